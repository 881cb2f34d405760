// Rules about the tree as a whole. Each check takes the root, so that it can be shown to fail on a made-up tree.
#include "tests/lint/source_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace luxdeck::lint {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr std::size_t kLongestSource = 500;   // lines
constexpr std::size_t kLongestDecision = 80;  // lines, one page

/// Folders of the machine that somebody happened to work on. A word before the slash makes it part of a
/// longer relative path or of a URL, which is fine.
Findings machinePathFindings(const fs::path& root) {
    static const std::regex machinePath("(^|[^A-Za-z0-9_.~})-])/(work|root|home)/");
    Findings findings;
    for (const std::string& file : filesBelow(root)) {
        const std::vector<std::string> lines = textLines(root / file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            // The pattern itself has to stand somewhere; long lines are data, not text.
            if (file == "tests/lint/repo_test.cpp" || lines[i].size() > 2000) continue;
            std::smatch match;
            if (std::regex_search(lines[i], match, machinePath)) {
                findings.push_back(file + ":" + std::to_string(i + 1) + ": names /" + match[2].str() +
                                   "/...; expected no absolute path of one machine");
            }
        }
    }
    return findings;
}

Findings longSourceFindings(const fs::path& root) {
    static const std::regex sources("(engine|tonemap|analysis|cli|gui|tests)/.*");
    Findings findings;
    for (const std::string& file : filesBelow(root)) {
        if (!isSource(file) || !std::regex_match(file, sources)) continue;
        const std::size_t lines = textLines(root / file).size();
        if (lines > kLongestSource) {
            findings.push_back(file + ": " + std::to_string(lines) + " lines; expected at most " +
                               std::to_string(kLongestSource));
        }
    }
    return findings;
}

/// What an algorithm estimates, what it is good for and when it fails has to be said beside it. An
/// algorithm is a folder with an estimator in it; the others hold what estimators share.
Findings missingCardFindings(const fs::path& root) {
    static const std::regex inAlgorithm("(engine/transport/[^/]+)/.*_estimator\\.(cpp|h)");
    std::set<std::string> algorithms;
    for (const std::string& file : filesBelow(root)) {
        std::smatch match;
        if (std::regex_match(file, match, inAlgorithm)) algorithms.insert(match[1]);
    }
    Findings findings;
    for (const std::string& folder : algorithms) {
        if (!fs::exists(root / folder / "README.md"))
            findings.push_back(folder + ": no algorithm card; expected README.md");
    }
    return findings;
}

Findings longDecisionFindings(const fs::path& root) {
    static const std::regex decision("docs/decisions/.*\\.md");
    Findings findings;
    for (const std::string& file : filesBelow(root)) {
        if (!std::regex_match(file, decision)) continue;
        const std::size_t lines = textLines(root / file).size();
        if (lines > kLongestDecision) {
            findings.push_back(file + ": " + std::to_string(lines) + " lines; expected one page, at most " +
                               std::to_string(kLongestDecision));
        }
    }
    return findings;
}

TEST(Repository, NamesNoMachine) {
    const Findings findings = machinePathFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Repository, NoSourceIsTooLong) {
    const Findings findings = longSourceFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Repository, EveryAlgorithmHasItsCard) {
    const Findings findings = missingCardFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Repository, EveryDecisionFitsAPage) {
    const Findings findings = longDecisionFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(RepositoryChecks, ObjectToABadTree) {
    const TemporaryTree tree;
    tree.write("docs/a.md", "fine: ../shared/work/x, https://example.org/home/x\nbad: /work/main\n");
    tree.write("projects/a.toml", "file = \"/home/ann/room.obj\"\n");
    tree.write("projects/data.bin", std::string("\0/root/", 7));
    EXPECT_THAT(machinePathFindings(tree.root()),
                ElementsAre(HasSubstr("docs/a.md:2: names /work/"), HasSubstr("projects/a.toml:1: names /home/")));

    std::string lines;
    for (std::size_t i = 0; i < kLongestSource; ++i) lines += "\n";
    tree.write("engine/core/just.cpp", lines);
    tree.write("engine/core/over.cpp", lines + "\n");
    tree.write("projects/over.csv", lines + "\n");
    EXPECT_THAT(longSourceFindings(tree.root()), ElementsAre(HasSubstr("engine/core/over.cpp: 501 lines")));

    tree.write("engine/transport/registry.cpp", "");
    tree.write("engine/transport/shared/shadow.cpp", "");
    tree.write("engine/transport/good/good_estimator.cpp", "");
    tree.write("engine/transport/good/README.md", "");
    tree.write("engine/transport/bad/bad_estimator.cpp", "");
    EXPECT_THAT(missingCardFindings(tree.root()), ElementsAre(HasSubstr("engine/transport/bad: no algorithm card")));

    tree.write("docs/decisions/0001-long.md", lines);
    tree.write("docs/decisions/0002-short.md", "# Short\n");
    EXPECT_THAT(longDecisionFindings(tree.root()), ElementsAre(HasSubstr("0001-long.md: 500 lines")));
}

}  // namespace
}  // namespace luxdeck::lint
