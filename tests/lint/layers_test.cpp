// Who may include whom, and which library may be named where: the table as data, and every #include checked against it.
#include "tests/lint/source_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
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
using testing::IsEmpty;

/// A layer and those it stands on directly; what these stand on is allowed too.
struct Layer {
    std::string folder;
    std::vector<std::string> standsOn;
};

const std::vector<Layer>& layers() {
    static const std::vector<Layer> table = {
        {"engine/core", {}},
        {"engine/scene", {"engine/core"}},
        {"engine/io", {"engine/scene"}},
        {"engine/raycast", {"engine/scene"}},
        {"engine/massive", {"engine/scene"}},
        {"engine/sampling", {"engine/scene"}},
        {"engine/transport", {"engine/io", "engine/raycast", "engine/massive", "engine/sampling"}},
        {"engine/volume", {"engine/transport"}},
        {"engine/holodeck", {"engine/transport"}},
        {"engine/rendercache", {"engine/transport"}},
        {"engine/cluster", {"engine/transport"}},
        {"engine/algorithms", {"engine/volume"}},
        {"tonemap", {"engine/core"}},
        {"analysis", {"engine/algorithms", "engine/holodeck", "engine/rendercache", "engine/cluster", "tonemap"}},
        {"cli", {"analysis"}},
        {"gui", {"analysis"}},
        {"tests", {"cli", "gui"}},
    };
    return table;
}

/// Headers of one library (a pattern for the name between the brackets) and the folders that may name
/// them. The first pattern that matches decides.
struct Library {
    std::string name;
    std::regex headers;
    std::vector<std::string> folders;
};

const std::vector<Library>& libraries() {
    static const std::vector<std::string> everywhere = {"engine", "tonemap", "analysis", "cli", "gui", "tests"};
    static const std::vector<Library> table = {
        {"the standard library", std::regex("[a-z_0-9]+"), everywhere},
        {"POSIX", std::regex("(sys|netinet|arpa)/.*|(unistd|fcntl|dirent|poll|signal|termios|netdb|spawn|sched|pthread|malloc)\\.h"),
         everywhere},
        {"fmt", std::regex("fmt/.*"), everywhere},
        {"Imath", std::regex("Imath/.*"), {"engine", "tonemap", "analysis", "gui", "tests"}},
        {"TBB", std::regex("(oneapi/)?tbb/.*"), {"engine/core", "tests"}},
        {"xxHash", std::regex("xxhash\\.h"), {"engine/core"}},
        {"OpenEXR", std::regex("OpenEXR/.*|Imf.*|Iex.*"), {"engine/io", "tests"}},
        {"libpng", std::regex("png(conf)?\\.h"), {"engine/io", "tests"}},
        {"libjpeg", std::regex("(jpeglib|jerror|turbojpeg)\\.h"), {"engine/io", "tests"}},
        {"stb", std::regex("(stb/)?stb_.*\\.h"), {"engine/io"}},
        {"toml++", std::regex("toml\\+\\+/.*|toml\\.hpp"), {"engine/io"}},
        {"assimp", std::regex("assimp/.*"), {"engine/io"}},
        {"tinygltf", std::regex("tiny_?gltf.*"), {"engine/io"}},
        {"nlohmann json", std::regex("nlohmann/.*"), {"engine/io", "engine/volume", "analysis", "cli", "tests"}},
        {"Embree", std::regex("embree.*"), {"engine/raycast", "tests/bench"}},
        {"LMDB", std::regex("lmdb.*"), {"engine/holodeck"}},
        {"MPI", std::regex("mpi\\.h"), {"engine/cluster"}},
        {"OpenColorIO", std::regex("OpenColorIO/.*"), {"tonemap"}},
        {"CLI11", std::regex("CLI/.*"), {"cli"}},
        {"VTK", std::regex("vtk.*|QVTK.*"), {"gui/view3d", "gui/drivers", "tests/gui"}},
        {"Qt Widgets",
         std::regex(
             "QtWidgets/.*|Q(Widget|Application|MainWindow|Dialog|DockWidget|Action|Menu|MenuBar|ToolBar|StatusBar|"
             "Label|PushButton|ComboBox|SpinBox|CheckBox|Slider|LineEdit|TableView|TreeView|ListView|Splitter|"
             "FormLayout|[HV]BoxLayout|GridLayout|FileDialog|MessageBox|ProgressBar|TabWidget)"),
         {"gui/app", "gui/panels", "gui/view3d", "gui/drivers", "tests/gui"}},
        {"Qt", std::regex("Qt?[A-Z].*"), {"analysis/report", "gui", "tests/gui"}},
        {"GoogleTest", std::regex("(gtest|gmock)/.*"), {"tests"}},
        {"Google Benchmark", std::regex("benchmark/.*"), {"tests/bench", "tests/gui/bench"}},
    };
    return table;
}

bool isIn(std::string_view path, std::string_view folder) {
    return path.starts_with(folder) && (path.size() == folder.size() || path[folder.size()] == '/');
}

const Layer* layerOf(std::string_view path) {
    for (const Layer& layer : layers()) {
        if (isIn(path, layer.folder)) return &layer;
    }
    return nullptr;
}

/// The layer itself and all below it.
std::set<std::string> reachable(const std::string& folder) {
    std::set<std::string> result = {folder};
    for (const std::string& below : layerOf(folder)->standsOn) result.merge(reachable(below));
    return result;
}

std::string objectionToProjectHeader(const std::string& file, const std::string& header) {
    const Layer* from = layerOf(file);
    const Layer* to = layerOf(header);
    if (from == nullptr) return "this folder is not in the layer table: add it to tests/lint/layers_test.cpp";
    if (to == nullptr) return "no layer of that name; expected a path from the top of the tree";
    if (reachable(from->folder).count(to->folder) == 0) {
        return from->folder + " may not include " + to->folder + ": arrows between layers never turn back or aside";
    }
    return {};
}

std::string objectionToLibraryHeader(const std::string& file, const std::string& header) {
    for (const Library& library : libraries()) {
        if (!std::regex_match(header, library.headers)) continue;
        const auto allows = [&](const std::string& folder) { return isIn(file, folder); };
        if (std::any_of(library.folders.begin(), library.folders.end(), allows)) return {};
        std::string folders;
        for (const std::string& folder : library.folders) folders += (folders.empty() ? "" : ", ") + folder;
        return library.name + " may only be named in " + folders;
    }
    return "an unknown library; expected one of the table in tests/lint/layers_test.cpp";
}

/// Every #include of the tree at `root` that the two tables forbid.
Findings layerFindings(const fs::path& root) {
    static const std::regex include(R"re(\s*#\s*include\s*[<"]([^>"]+)[>"].*)re");
    static const std::regex project("(engine|tonemap|analysis|cli|gui|tests)/.*");
    Findings findings;
    for (const std::string& file : filesBelow(root)) {
        if (!isSource(file) || !std::regex_match(file, project)) continue;
        const std::vector<std::string> lines = textLines(root / file);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            std::smatch match;
            if (!std::regex_match(lines[i], match, include)) continue;
            const std::string header = match[1];
            const bool ours = std::regex_match(header, project) || fs::exists((root / file).parent_path() / header);
            const std::string objection =
                ours ? objectionToProjectHeader(file, header) : objectionToLibraryHeader(file, header);
            if (!objection.empty()) {
                findings.push_back(file + ":" + std::to_string(i + 1) + ": includes " + header + "; " + objection);
            }
        }
    }
    return findings;
}

TEST(Layers, NoIncludeTurnsBack) {
    const Findings findings = layerFindings(LUXDECK_SOURCE_DIR);
    EXPECT_TRUE(findings.empty()) << joined(findings);
}

TEST(Layers, TheWholeTreeIsRead) {
    // A checker that reads nothing finds nothing.
    const std::vector<std::string> files = filesBelow(LUXDECK_SOURCE_DIR);
    EXPECT_THAT(files, testing::Contains("engine/core/statistics.cpp"));
    EXPECT_THAT(files, testing::Contains("tests/lint/layers_test.cpp"));
    EXPECT_GT(files.size(), 100u);
}

TEST(Layers, TableHasNoCycleAndNoSiblings) {
    const std::vector<std::string> siblings = {"engine/io", "engine/raycast", "engine/massive", "engine/sampling"};
    for (const std::string& a : siblings) {
        for (const std::string& b : siblings) EXPECT_EQ(reachable(a).count(b), a == b ? 1u : 0u) << a << " " << b;
    }
    // Each layer stands on layers above it in the table, so there is no way round.
    std::set<std::string> seen;
    for (const Layer& layer : layers()) {
        for (const std::string& below : layer.standsOn) EXPECT_EQ(seen.count(below), 1u) << layer.folder;
        seen.insert(layer.folder);
    }
}

/// One file with one include, in an otherwise empty tree.
Findings findingsFor(const std::string& file, const std::string& include) {
    const TemporaryTree tree;
    tree.write(file, "// made up\n#include " + include + "\n");
    return layerFindings(tree.root());
}

TEST(Layers, FindsWhatIsForbidden) {
    EXPECT_THAT(findingsFor("engine/core/a.h", "\"engine/scene/scene.h\""),
                ElementsAre(HasSubstr("engine/core/a.h:2: includes engine/scene/scene.h; engine/core may not")));
    const std::vector<std::pair<std::string, std::string>> forbidden = {
        {"engine/io/a.cpp", "\"engine/raycast/raycaster.h\""},  // sibling
        {"engine/volume/a.cpp", "\"engine/holodeck/store.h\""},  // sibling
        {"cli/a.cpp", "\"gui/app/window.h\""},  // sibling
        {"tonemap/a.cpp", "\"engine/scene/scene.h\""},  // stands on core alone
        {"engine/transport/path/a.cpp", "\"tonemap/camera.h\""},  // beside the chain
        {"analysis/grids/a.cpp", "\"cli/solve.h\""},  // back
        {"engine/core/a.cpp", "\"tests/support/scenes.h\""},  // product code on tests
        {"engine/core/a.cpp", "<engine/scene/scene.h>"},  // brackets hide nothing
        {"engine/shadows/a.cpp", "\"engine/core/rgb.h\""},  // no such layer
        {"engine/scene/a.cpp", "<embree4/rtcore.h>"},
        {"analysis/grids/a.cpp", "<QImage>"},
        {"analysis/report/a.cpp", "<QWidget>"},
        {"gui/session/a.cpp", "<vtkActor.h>"},
        {"gui/session/a.cpp", "<QMainWindow>"},
        {"engine/core/a.cpp", "<OpenColorIO/OpenColorIO.h>"},
        {"engine/io/a.cpp", "<CLI/CLI.hpp>"},
        {"tonemap/a.cpp", "<OpenEXR/ImfInputFile.h>"},
        {"engine/transport/a.cpp", "<nlohmann/json.hpp>"},
        {"engine/core/a.cpp", "<boost/optional.hpp>"},  // a library that nobody decided on
    };
    for (const auto& [file, include] : forbidden) {
        EXPECT_EQ(findingsFor(file, include).size(), 1u) << file << " " << include;
    }
}

TEST(Layers, FindsANeighbourNamedWithoutItsPath) {
    const TemporaryTree tree;
    tree.write("engine/core/rgb.h", "");
    tree.write("engine/core/a.cpp", "  #  include \"rgb.h\"  // indented\n");
    EXPECT_THAT(layerFindings(tree.root()), ElementsAre(HasSubstr("expected a path from the top")));
}

TEST(Layers, LetsPassWhatIsAllowed) {
    const std::vector<std::pair<std::string, std::string>> allowed = {
        {"engine/io/a.cpp", "\"engine/core/rgb.h\""},
        {"engine/transport/path/a.cpp", "\"engine/raycast/raycaster.h\""},
        {"analysis/compare/a.cpp", "\"engine/io/project.h\""},
        {"gui/app/a.cpp", "\"tonemap/human.h\""},
        {"engine/core/a.cpp", "<vector>"},
        {"engine/raycast/a.cpp", "<embree3/rtcore.h>"},
        {"analysis/report/a.cpp", "<QPdfWriter>"},
        {"gui/session/a.cpp", "<QObject>"},
        {"cli/a.cpp", "<CLI/CLI.hpp>"},
        {"tests/unit/a.cpp", "\"gui/session/session.h\""},
    };
    for (const auto& [file, include] : allowed) {
        EXPECT_THAT(findingsFor(file, include), IsEmpty()) << file << " " << include;
    }
}

}  // namespace
}  // namespace luxdeck::lint
