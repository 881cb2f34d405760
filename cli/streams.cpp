#include "cli/streams.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace luxdeck::cli {

void occupyClosedStreams() {
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; ++fd)
        if (::fcntl(fd, F_GETFD) < 0)  // opening takes the lowest free number, which is fd
            (void)::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY);  // the wrong way round: use is an error
}

void say(const std::string& text) {
    (void)std::fputs(text.c_str(), stderr);
    (void)std::fflush(stderr);
}

}  // namespace luxdeck::cli
