#include "engine/sampling/light_tree.h"

#include "engine/sampling/octahedral.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace luxdeck {

namespace {

/// This part of the choice at every node goes by flux.
constexpr float kDefensive = 0.02F;
/// The same of the choice among all lights at once, as with few lights.
constexpr double kDefensiveOfAll = 0.1;

/// No texel of a node's map is below this part of its mean: between the directions to its nearest point and to its
/// centre there may be beams.
constexpr float kMapFloor = 0.02F;

constexpr int kBuckets = 12;

/// Inside or near the bounds of many lights no distance is taken below this part of their half diagonal, squared.
constexpr float kNearest2 = 1.0F / 16;

/// Frames that differ by less share a node map, whose texels are 23 degrees wide.
constexpr float kFrameStep = 16;
using Key = std::array<std::int32_t, 7>;

Key keyOf(const TreeLight& light) {
    const auto step = [](float x) { return static_cast<std::int32_t>(std::lround(x * kFrameStep)); };
    const auto& f = light.frame;
    return {static_cast<std::int32_t>(light.map), step(f.normal.x), step(f.normal.y), step(f.normal.z),
            step(f.tangent.x), step(f.tangent.y), step(f.tangent.z)};
}

/// Where a plane across an axis divides lights best.
struct Plane {
    int axis = 0, bucket = 0;
    float low = 0, size = 0;  // of the centres along the axis [m]
    double cost = std::numeric_limits<double>::infinity();

    [[nodiscard]] int bucketOf(const Vec3& centre) const {
        return std::min(static_cast<int>((centre[axis] - low) / size * kBuckets), kBuckets - 1);
    }
};

/// The best of the evenly spaced planes across one axis: flux times squared size of both sides is least.
Plane bestPlane(std::span<const TreeLight> lights, std::span<const std::uint32_t> order, Plane plane) {
    struct Bucket {
        Box3 box;
        double power = 0;
        void add(const Bucket& o) { box.extendBy(o.box), power += o.power; }
        [[nodiscard]] double cost() const { return power * double{box.size().length2()}; }
    };
    std::array<Bucket, kBuckets> buckets, above;
    for (const auto i : order) {
        const auto& l = lights[i];
        buckets[static_cast<std::size_t>(plane.bucketOf(l.centre))].add({Box3(l.centre - l.half, l.centre + l.half), l.power});
    }
    for (std::size_t b = kBuckets - 1; b > 0; --b) {
        above[b] = buckets[b];
        if (b + 1 < kBuckets) above[b].add(above[b + 1]);
    }
    Bucket below;
    for (std::size_t b = 1; b < kBuckets; ++b) {
        below.add(buckets[b - 1]);
        const double cost = below.cost() + above[b].cost();
        if (below.power > 0 && above[b].power > 0 && cost < plane.cost) plane.cost = cost, plane.bucket = static_cast<int>(b);
    }
    return plane;
}

}  // namespace

struct LightTree::Building {
    std::span<const TreeLight> lights;
    std::vector<std::uint32_t> order;
    std::map<Key, std::uint32_t> mapOfKey;  // of leaves
};

double LightTree::Run::cost() const { return power * double{(high - low).length2()}; }

LightTree::LightTree(std::span<const TreeLight> lights, std::vector<float> maps) : maps_(std::move(maps)) {
    Building work{lights, std::vector<std::uint32_t>(lights.size()), {}};
    std::iota(work.order.begin(), work.order.end(), 0U);
    slotOfLight_.resize(lights.size());
    build(work, runOf(work, 0, static_cast<std::uint32_t>(lights.size())), 0);
    double power = 0;
    for (const auto& light : lights) power += light.power;
    for (const auto& node : nodes_)
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if ((node.link[i] & kLeaf) == 0) continue;
            leaves_.push_back(node.link[i] & ~kLeaf);
            leafPowers_.push_back(static_cast<float>(power > 0 ? lights[leaves_.back()].power / power : 1.0 / static_cast<double>(lights.size())));
        }
    nodes_.shrink_to_fit(), maps_.shrink_to_fit();
}

LightTree::Run LightTree::runOf(const Building& work, std::uint32_t first, std::uint32_t last) {
    Run run{first, last, {0, 0, 0}, {0, 0, 0}, 0};
    Box3 box;
    for (std::uint32_t i = first; i < last; ++i) {
        const auto& light = work.lights[work.order[i]];
        box.extendBy(light.centre - light.half), box.extendBy(light.centre + light.half);
        run.power += light.power;
    }
    run.low = box.min, run.high = box.max;
    return run;
}

/// Divides a run in two by the best plane; by number where all lie in one place.
std::array<LightTree::Run, 2> LightTree::split(Building& work, const Run& run) {
    const auto order = std::span(work.order).subspan(run.first, run.count());
    Box3 centres;
    for (const auto i : order) centres.extendBy(work.lights[i].centre);
    Plane best;
    for (int axis = 0; axis < 3; ++axis) {
        const float size = centres.max[axis] - centres.min[axis];
        if (!(size > 0)) continue;
        const auto plane = bestPlane(work.lights, order, {axis, 0, centres.min[axis], size});
        if (plane.cost < best.cost) best = plane;
    }
    std::uint32_t middle = run.first + run.count() / 2;
    if (best.bucket > 0) {
        const auto border = std::partition(order.begin(), order.end(),
                                           [&](auto i) { return best.bucketOf(work.lights[i].centre) < best.bucket; });
        middle = run.first + static_cast<std::uint32_t>(border - order.begin());
    }
    return {runOf(work, run.first, middle), runOf(work, middle, run.last)};
}

std::vector<LightTree::Run> LightTree::parts(Building& work, const Run& run) {
    std::vector<Run> parts{run};
    while (parts.size() < kWidth) {  // the costliest part is divided next
        const auto largest = std::max_element(parts.begin(), parts.end(), [](const Run& a, const Run& b) {
            return std::pair(a.count() > 1, a.cost()) < std::pair(b.count() > 1, b.cost());
        });
        if (largest->count() < 2) break;
        const auto halves = split(work, *largest);
        *largest = halves[0];
        parts.push_back(halves[1]);
    }
    return parts;
}

void LightTree::place(Node& node, std::uint32_t i, const Run& run, const Frame& frame, bool leaf) {
    const Vec3 centre = (run.low + run.high) * 0.5F, half = (run.high - run.low) * 0.5F;
    node.x[i] = centre.x, node.y[i] = centre.y, node.z[i] = centre.z;
    node.hx[i] = half.x, node.hy[i] = half.y, node.hz[i] = half.z;
    node.extent[i] = leaf ? 0.0F : 1.0F;
    node.least2[i] = std::max(half.length2() * (leaf ? 1.0F : kNearest2), 1e-20F);
    node.tx[i] = frame.tangent.x, node.ty[i] = frame.tangent.y, node.tz[i] = frame.tangent.z;
    node.bx[i] = frame.bitangent.x, node.by[i] = frame.bitangent.y, node.bz[i] = frame.bitangent.z;
    node.nx[i] = frame.normal.x, node.ny[i] = frame.normal.y, node.nz[i] = frame.normal.z;
    node.side[i] = leaf ? kMapSide : kNodeSide;
}

LightTree::Emission LightTree::build(Building& work, const Run& run, std::uint32_t above) {
    const auto parts = LightTree::parts(work, run);
    const auto index = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    Node node;  // put in its place last: nodes_ grows meanwhile
    node.count = static_cast<std::uint32_t>(parts.size()), node.above = above;
    std::vector<Emission> emissions;
    for (std::uint32_t i = 0; i < node.count; ++i) {
        const auto& part = parts[i];
        node.powerShare[i] = static_cast<float>(run.power > 0 ? part.power / run.power : double{1} * part.count() / run.count());
        if (part.count() == 1) {
            const auto which = work.order[part.first];
            const auto& light = work.lights[which];
            place(node, i, part, light.frame, true);
            emissions.push_back(leafEmission(work, light));
            node.map[i] = static_cast<std::int32_t>(light.map * kMapSide * kMapSide), node.scale[i] = light.scale;
            node.link[i] = kLeaf | which;
            slotOfLight_[which] = kWidth * index + i;
        } else {
            place(node, i, part, Frame{}, false);
            node.link[i] = static_cast<std::uint32_t>(nodes_.size());
            emissions.push_back(build(work, part, kWidth * index + i));
            node.map[i] = static_cast<std::int32_t>(emissions.back().map), node.scale[i] = static_cast<float>(emissions.back().scale);
        }
    }
    nodes_[index] = node;
    return together(emissions);
}

/// The map of a light, turned into the world's directions and smoothed: texel by texel the mean over twice its width.
LightTree::Emission LightTree::leafEmission(Building& work, const TreeLight& light) {
    const auto [entry, isNew] = work.mapOfKey.try_emplace(keyOf(light), static_cast<std::uint32_t>(maps_.size()));
    if (!isNew) return {entry->second, light.scale};
    constexpr int kSub = 6;
    const std::size_t map = std::size_t{light.map} * kMapSide * kMapSide;
    for (int y = 0; y < kNodeSide; ++y)
        for (int x = 0; x < kNodeSide; ++x) {
            float sum = 0;
            for (int j = 0; j < kSub; ++j)
                for (int i = 0; i < kSub; ++i) {
                    const auto along = [](int texel, int part) {
                        const float at = static_cast<float>(texel) - 0.5F + (static_cast<float>(part) + 0.5F) * 2 / kSub;
                        return std::clamp(at / kNodeSide, 0.0F, 1.0F);
                    };
                    sum += maps_[map + static_cast<std::size_t>(octahedralTexel(light.frame.toLocal(octahedralDirection(along(x, i), along(y, j))), kMapSide))];
                }
            maps_.push_back(sum / (kSub * kSub));
        }
    addFloor(entry->second);
    return {entry->second, light.scale};
}

void LightTree::addFloor(std::size_t map) {
    const auto texels = std::span(maps_).subspan(map, kNodeTexels);
    const float mean = std::accumulate(texels.begin(), texels.end(), 0.0F) / static_cast<float>(kNodeTexels);
    for (auto& texel : texels) texel = std::max(texel, kMapFloor * mean);
}

/// Parts that look alike share their map, so that a hall of equal luminaires has one.
LightTree::Emission LightTree::together(std::span<const Emission> parts) {
    Emission sum{parts[0].map, 0};
    for (const auto& part : parts) sum.scale += part.scale;
    if (std::all_of(parts.begin(), parts.end(), [&](const Emission& e) { return e.map == parts[0].map; })) return sum;
    sum.map = static_cast<std::uint32_t>(maps_.size());
    maps_.resize(maps_.size() + kNodeTexels, 0.0F);
    for (const auto& part : parts)
        for (std::size_t t = 0; t < kNodeTexels; ++t)
            maps_[sum.map + t] += maps_[part.map + t] * static_cast<float>(part.scale / sum.scale);
    return sum;
}

/// Written without branches, so that it is compiled to vector instructions.
LightTree::Shares LightTree::importances(const Node& r, const Receiver& at) const {
    const Vec3 p = at.position, n = at.normal;
    const float ax = std::abs(n.x), ay = std::abs(n.y), az = std::abs(n.z);
    const float leastCosine = ax + ay + az > 0 ? 0.0F : 1.0F;  // no normal: light from all sides counts in full
    Shares out;
    std::array<std::int32_t, kWidth> central, nearest;
    const auto texel = [&](std::uint32_t i, float x, float y, float z) {  // of the direction from the light, (-x, -y, -z)
        const float lx = -(r.tx[i] * x + r.ty[i] * y + r.tz[i] * z);
        const float ly = -(r.bx[i] * x + r.by[i] * y + r.bz[i] * z);
        const float lz = -(r.nx[i] * x + r.ny[i] * y + r.nz[i] * z);
        const float toOctahedron = 1 / (std::abs(lx) + std::abs(ly) + std::abs(lz) + 1e-30F);
        const float ox = lx * toOctahedron, oy = ly * toOctahedron;
        const float fx = std::copysign(1 - std::abs(oy), ox), fy = std::copysign(1 - std::abs(ox), oy);
        const float half = 0.5F * r.side[i], last = r.side[i] - 1;
        const float u = ((lz < 0 ? fx : ox) + 1) * half, v = ((lz < 0 ? fy : oy) + 1) * half;
        const float cu = u < last ? u : last, cv = v < last ? v : last;
        const auto row = static_cast<std::int32_t>(cv > 0 ? cv : 0), column = static_cast<std::int32_t>(cu > 0 ? cu : 0);
        return r.map[i] + row * static_cast<std::int32_t>(r.side[i]) + column;
    };
    for (std::uint32_t i = 0; i < kWidth; ++i) {
        const float x = r.x[i] - p.x, y = r.y[i] - p.y, z = r.z[i] - p.z;
        const float hx = r.hx[i] * r.extent[i], hy = r.hy[i] * r.extent[i], hz = r.hz[i] * r.extent[i];
        const float rx = std::abs(x), ry = std::abs(y), rz = std::abs(z);
        const float qx = rx > hx ? rx - hx : 0.0F, qy = ry > hy ? ry - hy : 0.0F, qz = rz > hz ? rz - hz : 0.0F;
        const float q2 = qx * qx + qy * qy + qz * qz;
        const float f2 = (rx + hx) * (rx + hx) + (ry + hy) * (ry + hy) + (rz + hz) * (rz + hz);
        const float shortest2 = q2 > r.least2[i] ? q2 : r.least2[i], longest2 = f2 > r.least2[i] ? f2 : r.least2[i];
        const float shortest = std::sqrt(shortest2);
        const float height = (n.x * x + n.y * y + n.z * z + ax * r.hx[i] + ay * r.hy[i] + az * r.hz[i]) / shortest;
        const float below1 = height < 1.0F ? height : 1.0F;
        const float cosine = below1 > leastCosine ? below1 : leastCosine;
        const float apart = f2 > 0 ? 1.0F : 0.0F;  // in the very place of a point light nothing comes from it
        out[i] = apart * r.scale[i] * cosine / (shortest * std::sqrt(longest2));
        const float inside = q2 > 0 ? 0.0F : 1.0F;  // then there is no nearest direction
        central[i] = texel(i, x, y, z);
        nearest[i] = texel(i, std::copysign(qx, x) + inside * x, std::copysign(qy, y) + inside * y, std::copysign(qz, z) + inside * z);
    }
    for (std::uint32_t i = 0; i < kWidth; ++i)
        out[i] *= maps_[static_cast<std::uint32_t>(central[i])] + maps_[static_cast<std::uint32_t>(nearest[i])];
    return out;
}

LightTree::Shares LightTree::shares(const Node& node, const Receiver& at) const {
    Shares out = importances(node, at);
    const float sum = ((out[0] + out[1]) + (out[2] + out[3])) + ((out[4] + out[5]) + (out[6] + out[7]));
    const bool known = sum > 0 && sum < std::numeric_limits<float>::infinity();
    const float byImportance = known ? (1 - kDefensive) / sum : 0.0F, byPower = known ? kDefensive : 1.0F;
    for (std::uint32_t i = 0; i < kWidth; ++i) out[i] = out[i] * byImportance + byPower * node.powerShare[i];
    return out;
}

LightTree::Draw LightTree::draw(const Receiver& at, float u) const {
    float probability = 1;
    for (std::uint32_t index = 0;;) {
        const auto& node = nodes_[index];
        const auto share = shares(node, at);
        std::uint32_t chosen = 0;
        float below = 0;  // rounding may leave u beyond the last: that one is taken
        while (chosen + 1 < node.count && u >= below + share[chosen]) below += share[chosen++];
        probability *= share[chosen];
        u = share[chosen] > 0 ? std::clamp((u - below) / share[chosen], 0.0F, 0x1.fffffep-1F) : 0;
        index = node.link[chosen];
        if ((index & kLeaf) != 0) return {index & ~kLeaf, probability};
    }
}

float LightTree::probability(const Receiver& at, std::uint32_t light) const {
    float probability = 1;
    for (std::uint32_t slot = slotOfLight_[light];; slot = nodes_[slot / kWidth].above) {
        probability *= shares(nodes_[slot / kWidth], at)[slot % kWidth];
        if (slot / kWidth == 0) return probability;
    }
}

std::vector<float> LightTree::weighAll(const Receiver& at) const {
    std::vector<float> out;
    out.reserve(leaves_.size());
    double sum = 0;
    for (const auto& node : nodes_) {
        Shares weights{};
        bool weighed = false;
        for (std::uint32_t i = 0; i < node.count; ++i) {
            if ((node.link[i] & kLeaf) == 0) continue;
            if (!weighed) weights = importances(node, at), weighed = true;
            out.push_back(weights[i]), sum += weights[i];
        }
    }
    const bool known = sum > 0 && sum < std::numeric_limits<float>::infinity();
    double below = 0;
    for (std::size_t k = 0; k < out.size(); ++k) {
        below += known ? (1 - kDefensiveOfAll) * out[k] / sum + kDefensiveOfAll * double{leafPowers_[k]} : double{leafPowers_[k]};
        out[k] = static_cast<float>(below);
    }
    return out;
}

/// What a light is chosen with is the difference of two sums as they are stored: exact, whatever their rounding.
LightTree::Draw LightTree::draw(std::span<const float> sums, float u) const {
    const float wanted = u * sums.back();
    const auto found = std::min<std::ptrdiff_t>(std::upper_bound(sums.begin(), sums.end(), wanted) - sums.begin(),
                                                static_cast<std::ptrdiff_t>(sums.size()) - 1);
    const auto k = static_cast<std::size_t>(found);
    return {leaves_[k], (sums[k] - (k > 0 ? sums[k - 1] : 0.0F)) / sums.back()};
}

std::size_t LightTree::bytes() const {
    return nodes_.size() * sizeof(Node) + size() * (2 * sizeof(std::uint32_t) + sizeof(float)) + maps_.size() * sizeof(float);
}

}  // namespace luxdeck
