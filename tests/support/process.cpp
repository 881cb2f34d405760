#include "tests/support/process.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace luxdeck::test {

namespace {

double now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::array<int, 2> makePipe() {
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    return ends;
}

/// In the child: only calls that are safe after fork.
[[noreturn]] void become(const ProcessSettings& settings, char* const* arguments, char* const* environment,
                         const std::array<int, 3>& streams) {
    for (int fd = 0; fd < 3; ++fd) ::dup2(streams[static_cast<std::size_t>(fd)], fd);
    if (settings.closeOutput) ::close(STDOUT_FILENO);
    if (!settings.folder.empty() && ::chdir(settings.folder.c_str()) != 0) ::_exit(127);
    if (settings.largestFile) {
        const rlimit limit{*settings.largestFile, *settings.largestFile};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ::signal(SIGPIPE, SIG_DFL);
    ::execve(arguments[0], arguments, environment);
    ::_exit(127);
}

std::vector<std::string> environmentOf(const ProcessSettings& settings) {
    std::vector<std::string> all;
    for (char** at = environ; *at != nullptr; ++at) {
        const std::string entry(*at);
        if (!settings.environment.contains(entry.substr(0, entry.find('=')))) all.push_back(entry);
    }
    for (const auto& [name, value] : settings.environment) all.push_back(name + "=" + value);
    return all;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> out;
    for (auto& text : texts) out.push_back(text.data());
    out.push_back(nullptr);
    return out;
}

}  // namespace

Process::Process(const ProcessSettings& settings) : timeoutSeconds_(settings.timeoutSeconds), start_(now()) {
    ::signal(SIGPIPE, SIG_IGN);  // a child that stops reading is a result, not our end
    const auto in = makePipe(), out = makePipe(), err = makePipe();
    auto arguments = settings.arguments;
    auto environment = environmentOf(settings);
    const auto argumentPointers = pointers(arguments);
    const auto environmentPointers = pointers(environment);
    pid_ = ::fork();
    if (pid_ == 0) become(settings, argumentPointers.data(), environmentPointers.data(), {in[0], out[1], err[1]});
    ::close(in[0]), ::close(out[1]), ::close(err[1]);
    in_ = in[1], out_ = out[0], err_ = err[0];
    ::fcntl(in_, F_SETFL, O_NONBLOCK);
    if (pid_ < 0) throw std::runtime_error("no process");
}

Process::~Process() {
    if (pid_ > 0) {
        ::kill(pid_, SIGKILL);
        ::waitpid(pid_, nullptr, 0);
    }
    close(in_), close(out_), close(err_);
}

void Process::close(int& descriptor) {
    if (descriptor >= 0) ::close(descriptor);
    descriptor = -1;
}

void Process::closeInput() { close(in_); }
void Process::closeOutput() { close(out_); }
void Process::closeErrors() { close(err_); }

bool Process::late() const { return now() - start_ > timeoutSeconds_; }

/// Takes what the process has written; false: both its streams are at their end.
bool Process::pump(int milliseconds) {
    std::array<pollfd, 2> waiting{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};  // poll passes over -1
    if (out_ < 0 && err_ < 0) return false;
    if (::poll(waiting.data(), waiting.size(), milliseconds) <= 0) return true;
    for (const auto stream : {0U, 1U}) {
        if (waiting[stream].revents == 0) continue;
        int& descriptor = stream == 0 ? out_ : err_;
        std::array<char, 65536> block;
        const auto got = ::read(descriptor, block.data(), block.size());
        if (got > 0) (stream == 0 ? result_.out : result_.err).append(block.data(), static_cast<std::size_t>(got));
        else if (got == 0 || errno != EINTR) close(descriptor);
    }
    return true;
}

bool Process::write(std::string_view text) {
    while (!text.empty() && !late()) {
        const auto taken = ::write(in_, text.data(), text.size());
        if (taken > 0) text.remove_prefix(static_cast<std::size_t>(taken));
        else if (errno != EAGAIN && errno != EINTR) return false;
        else if (!pump(5)) ::usleep(1000);
    }
    return text.empty();
}

std::optional<std::string> Process::readLine() {
    while (true) {
        const auto end = result_.out.find('\n', lineStart_);
        if (end != std::string::npos) {
            auto line = result_.out.substr(lineStart_, end - lineStart_);
            lineStart_ = end + 1;
            return line;
        }
        if (out_ < 0 || late()) return std::nullopt;
        pump(20);
    }
}

void Process::signal(int number) const {
    if (pid_ > 0) ::kill(pid_, number);
}

ProcessResult Process::wait() {
    close(in_);
    while (!late() && pump(20)) {}
    int status = 0;
    rusage usage{};
    while (::wait4(pid_, &status, WNOHANG, &usage) == 0) {
        if (late()) {
            result_.timedOut = true;
            ::kill(pid_, SIGKILL);
            ::wait4(pid_, &status, 0, &usage);
            break;
        }
        ::usleep(1000);
    }
    pid_ = -1;
    if (WIFEXITED(status)) result_.exitStatus = WEXITSTATUS(status);
    if (WIFSIGNALED(status)) result_.signal = WTERMSIG(status);
    result_.peakKilobytes = usage.ru_maxrss;
    return result_;
}

ProcessResult runProcess(const ProcessSettings& settings, std::string_view input) {
    Process process(settings);
    process.write(input);
    return process.wait();
}

}  // namespace luxdeck::test
