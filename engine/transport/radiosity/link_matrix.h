#pragma once

#include "engine/core/rgb.h"
#include "engine/core/vec.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace luxdeck {

/// A part of one element's light that it has from another.
struct ElementLink {
    std::uint32_t to = 0;   // the element that is seen
    Rgb weight;             // this one's irradiance for each lx of that one's
};

/// The equations E = c + K E of the elements' indirect irradiances: K sparse, by rows.
class LinkMatrix {
public:
    /// Takes the rows, one for each element.
    explicit LinkMatrix(std::span<const std::vector<ElementLink>> rows);

    /// Solves by Gauss and Seidel's method; between sweeps the mean error of all elements that exchange light, which
    /// takes 1 / (1 - reflectance) sweeps to die by itself, is taken out at once.
    ///
    /// constant   #E, c [lx]
    /// areasM2    #E
    /// lux        #E, becomes E
    /// returns    what is left: sum of area times |c + K E - E| over sum of area times E [-]; above kEnough: not solved
    double solve(std::span<const Rgb> constant, std::span<const float> areasM2, std::span<Rgb> lux) const;
    static constexpr double kEnough = 1e-7;

private:
    /// In double: where little is absorbed, what rounding leaves adds up over many reflections.
    using Lux = Vec3d;
    [[nodiscard]] Lux received(std::size_t row, std::span<const Lux> lux) const;
    [[nodiscard]] double correct(std::span<const Rgb> constant, std::span<const float> areasM2, std::span<Lux> lux) const;

    std::vector<std::size_t> first_;   // of each row, and one past the last
    std::vector<ElementLink> links_;
    std::vector<Lux> sums_;            // of each row's weights
    std::vector<std::uint32_t> groups_;  // of each row
};

}  // namespace luxdeck
