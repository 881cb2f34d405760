#include "engine/io/photometry_flux.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace luxdeck::photometry {
namespace {

constexpr double kAgreement = 0.01;      // the deviation that needs a reason
constexpr double kSameFigure = 0.002;    // headers are rounded to a few digits: this close is the same number

bool agrees(double value, double target, double tolerance) {
    return std::abs(value - target) <= tolerance * std::abs(target);
}

/// Flux per plane of type C (lm, if all planes were like it), each value standing for the zone about its angle.
/// This midpoint sum is what most header generators compute.
std::vector<double> zonalFluxByPlane(const StoredPlanes& stored) {
    const auto& v = stored.vertical;
    std::vector<double> flux(stored.horizontal.size(), 0.0);
    for (std::size_t i = 0; i < v.size(); ++i) {
        const double low = i == 0 ? v[i] : 0.5 * (v[i - 1] + v[i]);
        const double high = i + 1 == v.size() ? v[i] : 0.5 * (v[i] + v[i + 1]);
        const double zone = 2 * kPiD * (std::cos(low * kDegree) - std::cos(high * kDegree));
        for (std::size_t h = 0; h < flux.size(); ++h) flux[h] += zone * stored.candela[h * v.size() + i];
    }
    return flux;
}

double mean(const double* first, const double* last) {
    double sum = 0;
    for (const double* f = first; f != last; ++f) sum += *f;
    return sum / static_cast<double>(last - first);
}

/// Mean over the stored planes by the trapezoid rule.
double trapezoidMean(const std::vector<double>& flux, const std::vector<double>& horizontal) {
    double sum = 0;
    double width = 0;
    for (std::size_t h = 0; h + 1 < flux.size(); ++h) {
        const double step = std::fmod(horizontal[h + 1] - horizontal[h] + 360, 360.0);  // EULUMDAT's 270..0..90
        sum += 0.5 * (flux[h] + flux[h + 1]) * step;
        width += step;
    }
    return sum / width;
}

/// A header computed with one of the usual coarse sums over the stored angles, if the claim is one.
std::optional<std::string> coarseSum(const StoredPlanes& stored, double claimed) {
    if (stored.type != PhotometryType::C) return std::nullopt;
    const auto flux = zonalFluxByPlane(stored);
    const double* first = flux.data();
    const double* last = first + flux.size();
    struct Candidate {
        const char* name;
        double lumens;
    };
    std::vector<Candidate> candidates;
    // All stored planes alike: exact for a full circle without 360, coarse where the end planes of a half
    // or quarter should count half.
    candidates.push_back({"zonal sum with every stored plane weighted alike", mean(first, last)});
    if (flux.size() > 2) {
        candidates.push_back({"zonal sum that leaves out the last stored plane", mean(first, last - 1)});
        candidates.push_back({"zonal sum that leaves out the first stored plane", mean(first + 1, last)});
        candidates.push_back({"zonal sum over the stored angles", trapezoidMean(flux, stored.horizontal)});
    }
    for (const auto& [name, lumens] : candidates) {
        if (agrees(lumens, claimed, kSameFigure)) {
            return fmt::format(
                "the header's flux is a {} ({:.5g} lm); the integral of the interpolated intensities differs", name,
                lumens);
        }
    }
    return std::nullopt;
}

/// A part of the sphere that the file leaves out, if that can be what is missing.
std::optional<std::string> missingPart(const Photometry& p, const FluxClaim& claim) {
    const double lumens = p.table.lumens();
    if (p.table.type() != PhotometryType::C || lumens >= claim.lumens) return std::nullopt;
    const double first = p.table.vertical().front();
    const double last = p.table.vertical().back();
    const double down = claim.downwardPercent / 100;
    if (down > 0 && down < 1 && last <= 90 && agrees(lumens, claim.lumens * down, kAgreement)) {
        return fmt::format("only the lower hemisphere is stored; the header puts {:.4g} % of the flux there",
                           claim.downwardPercent);
    }
    if (down >= 0 && down < 1 && first >= 90 && agrees(lumens, claim.lumens * (1 - down), kAgreement)) {
        return fmt::format("only the upper hemisphere is stored; the header puts {:.4g} % of the flux there",
                           100 - claim.downwardPercent);
    }
    return std::nullopt;
}

/// Why the table's flux is not the claimed one; the deviation is known to exceed 1 %.
std::string reason(const Photometry& p, const FluxClaim& claim, const StoredPlanes& stored) {
    const double lumens = p.table.lumens();
    const double ratio = lumens / claim.lumens;
    if (claim.of == FluxClaim::Of::Lamps && ratio <= 1) {
        // No luminaire worth measuring keeps nine tenths of its light.
        return fmt::format("light output ratio {:.3f}: lamps {:.5g} lm ({}), luminaire {:.5g} lm{}", ratio,
                           claim.lumens, claim.statedAs, lumens,
                           ratio < 0.1 ? "; so little that a factor is missing somewhere" : "");
    }
    if (const auto why = missingPart(p, claim)) return *why;
    if (const auto why = coarseSum(stored, claim.lumens)) return *why;
    if (claim.of == FluxClaim::Of::Lamps) {
        return fmt::format(
            "the intensities give {:.5g} lm, {:.4g} times the lamp flux in the header ({}), which no "
            "luminaire can: the header's lamp flux is nominal or wrong; the intensities are used",
            lumens, ratio, claim.statedAs);
    }
    if (agrees(1000 * ratio, claim.lampLumens, kAgreement)) {
        return fmt::format(
            "the intensities look absolute instead of per 1000 lm: taken as candela they give the {:.5g} lm "
            "of the header; read per 1000 lm, as the format says",
            claim.lumens);
    }
    const double outputRatio = claim.lampLumens > 0 ? lumens / claim.lampLumens : 0;
    return fmt::format(
        "table and header contradict each other: the intensities give {:.5g} lm (light output ratio "
        "{:.3f}{}), the header {:.5g} lm ({}), and no usual sum over the angles explains it; the "
        "intensities are used",
        lumens, outputRatio, outputRatio > 1.01 ? ", impossible" : "", claim.lumens, claim.statedAs);
}

}  // namespace

void judgeFlux(Photometry& p, const FluxClaim& claim, const StoredPlanes& stored) {
    const double lumens = p.table.lumens();
    if (!(lumens > 0)) {
        p.warnings.emplace_back("flux: all intensities are 0");
    } else if (claim.of == FluxClaim::Of::Nothing) {
        p.warnings.push_back(
            fmt::format("flux: absolute photometry, the header states none; {:.5g} lm from the "
                        "intensities",
                        lumens));
    } else if (!(claim.lumens > 0)) {
        p.warnings.push_back(fmt::format("flux: the header states a flux of 0 ({}); {:.5g} lm from the intensities",
                                         claim.statedAs, lumens));
    } else if (!agrees(lumens, claim.lumens, kAgreement)) {
        p.warnings.push_back("flux: " + reason(p, claim, stored));
    }

    const double downPercent = lumens > 0 ? 100 * p.table.lumensDown() / lumens : 0;
    // DFF is printed to the nearest percent by many tools, and zonal sums put the zone about 90 degrees on one side.
    if (claim.downwardPercent >= 0 && claim.lumens > 0 && std::abs(downPercent - claim.downwardPercent) > 1) {
        p.warnings.push_back(fmt::format("downward share: {:.2f} % from the intensities, {:.2f} % in the header (DFF)",
                                         downPercent, claim.downwardPercent));
    }
    const double efficacy = p.watts > 0 ? lumens / p.watts : 0;
    if (efficacy > 250) {
        p.warnings.push_back(
            fmt::format("{:.0f} lm/W is more than any lamp gives: {:.5g} lm from {:.4g} W", efficacy, lumens, p.watts));
    }
}

}  // namespace luxdeck::photometry
