#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace luxdeck::test {

/// How a process is started.
struct ProcessSettings {
    std::vector<std::string> arguments;          ///< the program's path first
    std::map<std::string, std::string> environment;  ///< beside what this process has
    std::filesystem::path folder;                ///< it works in; empty: here
    std::optional<std::size_t> largestFile;      ///< [bytes] a file may grow to, as on a full disk
    bool closeOutput = false;                    ///< it starts without a stdout
    double timeoutSeconds = 60;                  ///< killed then
};

/// How a process ended, and what it said.
struct ProcessResult {
    int exitStatus = -1;     ///< -1: a signal ended it
    int signal = 0;          ///< that ended it
    bool timedOut = false;
    std::string out, err;
    long peakKilobytes = 0;  ///< of resident memory
};

/// A program that runs beside the test; it is killed when this object goes.
class Process {
public:
    explicit Process(const ProcessSettings& settings);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    /// Waits until the process has taken all of it, reading meanwhile; false: it no longer reads.
    bool write(std::string_view text);
    void closeInput();
    void closeOutput();  ///< as a reader that has seen enough
    void closeErrors();
    /// The next line of its stdout, without the end; nullopt: it ended or the time is up.
    std::optional<std::string> readLine();
    void signal(int number) const;
    ProcessResult wait();

private:
    bool pump(int milliseconds);
    [[nodiscard]] bool late() const;
    static void close(int& descriptor);

    double timeoutSeconds_;
    double start_;
    pid_t pid_ = -1;
    int in_ = -1, out_ = -1, err_ = -1;
    std::size_t lineStart_ = 0;
    ProcessResult result_;
};

/// Starts, gives it `input`, and waits.
ProcessResult runProcess(const ProcessSettings& settings, std::string_view input = {});

}  // namespace luxdeck::test
