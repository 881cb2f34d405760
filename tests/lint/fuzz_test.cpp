// A reader that no fuzz target runs is a reader that anything may break.
#include "tests/lint/source_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <regex>
#include <string>

namespace luxdeck::lint {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// Headers of readers that are reached through the target of another.
const std::map<std::string, std::string>& reachedThrough() {
    static const std::map<std::string, std::string> table{
        {"cli/load.h", "project"},
        {"engine/io/gensky_options.h", "rad"},
        {"engine/io/gltf_document.h", "gltf"},
        {"engine/io/gltf_light.h", "gltf"},
        {"engine/io/gltf_material.h", "gltf"},
        {"engine/io/gltf_uri.h", "gltf"},
        {"engine/io/ies_labels.h", "ies"},
        {"engine/io/ies_tilt.h", "ies"},
        {"engine/io/obj_material.h", "obj"},
        {"engine/io/obj_mtl.h", "obj"},
        {"engine/io/photometry_text.h", "ies"},
        {"engine/io/project_sections.h", "project"},
        {"engine/io/rad_stream.h", "rad"},
        {"engine/io/rgbe_header.h", "rgbe"},
        {"engine/io/toml_reader.h", "project"},
        {"engine/io/xform.h", "rad"},
        {"engine/volume/volume_header.h", "volume"},
    };
    return table;
}

/// Whether a header declares a function that makes something of bytes or of a file.
bool declaresReader(const fs::path& header) {
    static const std::regex reader("Result<.*>\\s+(read|parse|load|decode)\\w*\\(");
    for (const std::string& line : textLines(header))
        if (std::regex_search(line, reader)) return true;
    return false;
}

Findings unfuzzedFindings(const fs::path& root) {
    std::string targets;
    Findings findings;
    static const std::regex target("tests/fuzz/(\\w+)_fuzz\\.cpp"), reading("(engine/io|engine/volume|analysis|cli|tonemap)/.*\\.h");
    std::smatch match;
    for (const std::string& file : filesBelow(root)) {
        if (!std::regex_match(file, match, target)) continue;
        for (const std::string& line : textLines(root / file)) targets += line + "\n";
        const fs::path corpus = root / "tests/fuzz/corpus" / match[1].str();
        if (!fs::is_directory(corpus) || fs::is_empty(corpus)) findings.push_back(file + ": no corpus; expected files in tests/fuzz/corpus/" + match[1].str());
    }
    for (const std::string& file : filesBelow(root)) {
        if (!std::regex_match(file, reading) || !declaresReader(root / file)) continue;
        if (targets.find("\"" + file + "\"") != std::string::npos) continue;
        const auto through = reachedThrough().find(file);
        if (through != reachedThrough().end() && fs::exists(root / "tests/fuzz" / (through->second + "_fuzz.cpp"))) continue;
        findings.push_back(file + ": a reader without a fuzz target; expected tests/fuzz/<reader>_fuzz.cpp that includes it, with a corpus");
    }
    return findings;
}

TEST(Fuzzing, EveryReaderHasATargetAndACorpus) {
    const Findings findings = unfuzzedFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(FuzzingChecks, ObjectToABadTree) {
    const TemporaryTree tree;
    tree.write("engine/io/good.h", "Result<Good> readGood(std::string_view bytes);\n");
    tree.write("engine/io/bad.h", "    static Result<Bad> parse(std::string_view bytes);\n");
    tree.write("engine/io/xform.h", "Result<Xform> parseXform();\n");  // its target, rad, is not there
    tree.write("engine/io/other.h", "Result<int> count();\n");
    tree.write("tests/fuzz/good_fuzz.cpp", "#include \"engine/io/good.h\"\n");
    EXPECT_THAT(unfuzzedFindings(tree.root()),
                ElementsAre(HasSubstr("good_fuzz.cpp: no corpus"), HasSubstr("engine/io/bad.h: a reader"), HasSubstr("engine/io/xform.h: a reader")));
    tree.write("tests/fuzz/corpus/good/one.txt", "1");
    EXPECT_THAT(unfuzzedFindings(tree.root()), ElementsAre(HasSubstr("bad.h"), HasSubstr("xform.h")));
}

}  // namespace
}  // namespace luxdeck::lint
