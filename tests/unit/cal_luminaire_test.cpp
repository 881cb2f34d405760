// A luminaire as ies2rad writes it, from its files to the luminance that leaves its opening.
#include "engine/io/rad_reader.h"
#include "engine/scene/appearance.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace luxdeck {
namespace {

namespace fs = std::filesystem;

TEST(CalLuminaire, FromIes2radHasItsIntensityWhereverItHangs) {
    const fs::path folder = fs::temp_directory_path() / ("luxdeck-ies2rad-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    // Candelas over 179, in planes of 30 degrees and cones of 15; the opening is 0.6 m x 0.2 m and looks down.
    const double area = 0.6 * 0.2;
    const auto candela = [](double h, double v) { return 1790 + 17.9 * v - 3.58 * h; };
    {
        std::ofstream data(folder / "lamp.dat");
        data << "2\n0 90 4\n0 90 7\n";
        for (int h = 0; h <= 90; h += 30)
            for (int v = 0; v <= 90; v += 15) data << std::to_string(candela(h, v) / 179) << "\n";
        std::ofstream(folder / "lamp.rad")
            << "void brightdata lamp_dist\n5 flatcorr lamp.dat source.cal src_phi4 src_theta\n"
               "0\n1 8.3333333333333\n\n"
               "lamp_dist light lamp_light\n0\n0\n3 1 1 1\n\n"
               "lamp_light polygon lamp.d\n0\n0\n12\n"
               "-0.3 -0.1 0  -0.3 0.1 0  0.3 0.1 0  0.3 -0.1 0\n";
        std::ofstream(folder / "scene.rad") << "!xform -rz 90 -t 2 3 2.5 lamp.rad\n";
    }
    const auto part = readRad({folder / "scene.rad"}, {});
    fs::remove_all(folder);
    ASSERT_TRUE(part) << part.error().text();
    const Scene& scene = part->scene;
    const auto lit = std::find_if(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& m) { return m.emissionPattern >= 0; });
    ASSERT_NE(lit, scene.materials.end());
    for (double v = 4; v < 89; v += 4)  // straight down all planes meet, and these data do not
        for (double h = 0; h <= 90; h += 9) {
            // Turned by 90 degrees about z with the luminaire.
            const double sine = std::sin(v * kDegree), cosine = std::cos(v * kDegree), turned = (h + 90) * kDegree;
            PatternPoint at;
            at.position = {2, 3, 2.5};
            at.normal = Vec3(0, 0, -1);
            at.direction = Vec3(Vec3d(-sine * std::cos(turned), -sine * std::sin(turned), cosine));
            const double cdM2 = luminance(emittedRadiance(scene, *lit, at), scene.weights);
            // Bilinear data are exact. Six digits in the file, and float directions, whose error the cosine of 88
            // degrees divides by 0.035: 2e-6 each; the weights of Radiance's primaries add up to 1.
            EXPECT_NEAR(cdM2 * area * cosine / candela(h, v), 1, 1e-5) << v << " " << h;
        }
}

}  // namespace
}  // namespace luxdeck
