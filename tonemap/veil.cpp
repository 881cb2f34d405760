#include "tonemap/veil.h"

#include "engine/core/parallel.h"

#include <algorithm>
#include <cmath>

namespace luxdeck::tonemap {

namespace {

/// A rectangle of samples, seen as one.
struct Node {
    Vec3d direction{0};       // mean by solid angle, unit
    Vec3d lightDirection{0};  // mean by luminance and solid angle, unit: a lamp in a dark group stays where it is
    Vec3d light{0};           // sum of L * solid angle
    double solidAngle = 0;    // sum
    double radius = 0;        // largest chord from `direction` to a sample
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // samples [x0, x1) x [y0, y1)
    int firstChild = -1;      // children are consecutive
    int childCount = 0;
};

/// The samples as a tree of rectangles, each split into up to four.
class SampleTree {
public:
    explicit SampleTree(const FovealImage& foveal) : foveal_(foveal) {
        nodes_.push_back(summary(0, 0, foveal.picture.width, foveal.picture.height));
        for (std::size_t i = 0; i < nodes_.size(); ++i) split(i);
    }

    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }

private:
    [[nodiscard]] std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(foveal_.picture.width) +
               static_cast<std::size_t>(x);
    }

    [[nodiscard]] Node summary(int x0, int y0, int x1, int y1) const {
        Node node;
        node.x0 = x0, node.y0 = y0, node.x1 = x1, node.y1 = y1;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x) {
                const double omega = foveal_.solidAngles[index(x, y)];
                const Rgb& c = foveal_.picture.at(x, y);
                node.solidAngle += omega;
                node.light += Vec3d(c.r, c.g, c.b) * omega;
                node.direction += foveal_.directions[index(x, y)] * omega;
                node.lightDirection += foveal_.directions[index(x, y)] * (omega * luminance(c));
            }
        if (node.direction.length2() > 0) node.direction.normalize();
        if (node.lightDirection.length2() > 0) node.lightDirection.normalize();
        else node.lightDirection = node.direction;
        for (int y = y0; y < y1; ++y)
            for (int x = x0; x < x1; ++x)
                if (foveal_.inView(index(x, y)))
                    node.radius = std::max(node.radius, (foveal_.directions[index(x, y)] - node.direction).length());
        return node;
    }

    void split(std::size_t i) {
        const Node parent = nodes_[i];
        const int width = parent.x1 - parent.x0, height = parent.y1 - parent.y0;
        if (width * height <= 1 || parent.solidAngle <= 0) return;
        const int xm = parent.x0 + (width + 1) / 2, ym = parent.y0 + (height + 1) / 2;
        nodes_[i].firstChild = static_cast<int>(nodes_.size());
        for (const auto& [ya, yb] : {std::pair(parent.y0, ym), std::pair(ym, parent.y1)})
            for (const auto& [xa, xb] : {std::pair(parent.x0, xm), std::pair(xm, parent.x1)})
                if (xa < xb && ya < yb) nodes_.push_back(summary(xa, ya, xb, yb));
        nodes_[i].childCount = static_cast<int>(nodes_.size()) - nodes_[i].firstChild;
    }

    const FovealImage& foveal_;
    std::vector<Node> nodes_;
};

/// cos(angle) / angle^2 for two unit directions `chord` apart; 0 behind.
double scatter(double chord2) {
    const double cosine = 1 - 0.5 * chord2;
    if (cosine <= 0) return 0;
    const double angle = std::max(2 * std::asin(0.5 * std::sqrt(chord2)), 1e-6);
    return cosine / (angle * angle);
}

Rgb veilAt(const std::vector<Node>& nodes, const Vec3d& direction, int x, int y, double openingAngle) {
    Vec3d light(0);
    double weights = 0;
    std::vector<int> stack{0};
    while (!stack.empty()) {
        const Node& node = nodes[static_cast<std::size_t>(stack.back())];
        stack.pop_back();
        if (node.solidAngle <= 0) continue;
        const bool inside = x >= node.x0 && x < node.x1 && y >= node.y0 && y < node.y1;
        const double chord2 = (direction - node.direction).length2();
        const bool far = !inside && node.radius * node.radius <= openingAngle * openingAngle * chord2;
        if (node.childCount > 0 && !far) {
            for (int c = node.childCount - 1; c >= 0; --c) stack.push_back(node.firstChild + c);
        } else if (!inside) {
            light += node.light * scatter((direction - node.lightDirection).length2());
            weights += node.solidAngle * scatter(chord2);
        }
    }
    if (!(weights > 0)) return {};
    light *= kVeilFraction / weights;
    return {static_cast<float>(light.x), static_cast<float>(light.y), static_cast<float>(light.z)};
}

/// Gives samples just outside of a fisheye's circle the mean of their neighbours in view: the rim interpolates
/// from them.
void extendOverTheRim(Picture& veil, const FovealImage& foveal) {
    const Picture inside = veil;
    for (int y = 0; y < veil.height; ++y)
        for (int x = 0; x < veil.width; ++x) {
            const auto inView = [&](int sx, int sy) {
                return foveal.inView(static_cast<std::size_t>(sy) * static_cast<std::size_t>(veil.width) +
                                     static_cast<std::size_t>(sx));
            };
            if (inView(x, y)) continue;
            Rgb sum;
            int count = 0;
            for (int sy = std::max(y - 1, 0); sy <= std::min(y + 1, veil.height - 1); ++sy)
                for (int sx = std::max(x - 1, 0); sx <= std::min(x + 1, veil.width - 1); ++sx)
                    if (inView(sx, sy)) sum += inside.at(sx, sy), ++count;
            if (count > 0) veil.at(x, y) = sum / static_cast<float>(count);
        }
}

}  // namespace

Picture veil(const FovealImage& foveal, double openingAngle) {
    const SampleTree tree(foveal);
    Picture out{foveal.picture.width, foveal.picture.height, std::vector<Rgb>(foveal.picture.pixels.size())};
    parallelFor(static_cast<std::size_t>(out.height), [&](std::size_t row) {
        for (int x = 0; x < out.width; ++x) {
            const int y = static_cast<int>(row);
            const std::size_t i = row * static_cast<std::size_t>(out.width) + static_cast<std::size_t>(x);
            if (foveal.inView(i)) out.at(x, y) = veilAt(tree.nodes(), foveal.directions[i], x, y, openingAngle);
        }
    });
    extendOverTheRim(out, foveal);
    return out;
}

void addVeil(Picture& picture, const Picture& veil) {
    const double stepX = static_cast<double>(veil.width) / picture.width,
                 stepY = static_cast<double>(veil.height) / picture.height;
    parallelFor(static_cast<std::size_t>(picture.height), [&](std::size_t row) {
        for (int x = 0; x < picture.width; ++x) {
            const int y = static_cast<int>(row);
            Rgb& c = picture.at(x, y);
            c = c * static_cast<float>(1 - kVeilFraction) + bilinear(veil, (x + 0.5) * stepX, (y + 0.5) * stepY);
        }
    });
}

}  // namespace luxdeck::tonemap
