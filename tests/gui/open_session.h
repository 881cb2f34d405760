#pragma once

#include "gui/session/session.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <unistd.h>

namespace luxdeck::gui::test {

namespace fs = std::filesystem;

/// A folder of its own, gone at the end.
class OwnFolder {
public:
    OwnFolder() {
        std::string pattern = (fs::temp_directory_path() / "luxdeck-gui-XXXXXX").string();
        path_ = mkdtemp(pattern.data());
    }
    ~OwnFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }
    /// A copy of one of the sample projects in it; its project.toml.
    [[nodiscard]] fs::path sample(const std::string& name) const {
        const fs::path projects = fs::path(LUXDECK_SOURCE_DIR) / "projects";
        for (const auto& folder : {name, std::string("common")})
            if (fs::exists(projects / folder)) fs::copy(projects / folder, path_ / folder, fs::copy_options::recursive | fs::copy_options::skip_existing);
        return path_ / name / "project.toml";
    }

private:
    fs::path path_;
};

/// A session whose thread is the test's.
class OpenSession {
public:
    Session session{[this] {
        const std::lock_guard lock(mutex_);
        woken_ = true;
        condition_.notify_one();
    }};

    /// Delivers until it is so; false: not within two minutes.
    bool until(const std::function<bool()>& so) {
        const auto end = std::chrono::steady_clock::now() + std::chrono::minutes(2);
        while (!so()) {
            std::unique_lock lock(mutex_);
            if (!condition_.wait_until(lock, end, [this] { return woken_; })) return false;
            woken_ = false;
            lock.unlock();
            session.deliver();
        }
        return true;
    }
    bool untilIdle() {
        return until([this] { return session.place.jobs.idle(); });
    }
    bool open(const fs::path& file) {
        session.open(file);
        return untilIdle() && session.project() != nullptr;
    }
    /// The log's errors, a line each.
    [[nodiscard]] std::string errors() const {
        std::string text;
        for (const auto& entry : session.place.log())
            if (entry.severity == Severity::Error) text += entry.text + "\n";
        return text;
    }

private:
    std::mutex mutex_;
    std::condition_variable condition_;
    bool woken_ = false;
};

}  // namespace luxdeck::gui::test
