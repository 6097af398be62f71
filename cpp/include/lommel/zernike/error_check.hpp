// Error control of an image: allowed errors from a preview of the field, then error bounds from the computed values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/limits.hpp"

namespace lommel {

// Preview of an image: intensities at some distances from the axis, in ascending order of the distance.
struct Looks {
    std::vector<double> v, bright;  // v: distance; bright: largest sampled intensity at this distance

    // Largest sampled intensity between the distances `from` and `to`, including the next sample beyond each end.
    double brightest(double from, double to) const {
        double most = 0.0;
        for (std::size_t i = 0; i < v.size(); ++i) {
            if ((i + 1 == v.size() || v[i + 1] >= from) && (i == 0 || v[i - 1] <= to)) {
                most = std::max(most, bright[i]);
            }
        }
        return most;
    }
};

// Error of U that changes I by `all`, if |U| is at most brighter * sqrt(intensity): solves e (2 |U| + e) = all for e.
inline double allowed_error(double all, double intensity, double brighter) {
    const double u = brighter * std::sqrt(intensity);
    return all / (u + std::sqrt(u * u + all));
}

struct PaintedPart {
    double error = 0.0, top = 0.0;  // error: error bound of U; top: largest computed intensity
    double error_bound() const { return intensity_error(std::sqrt(top), error); }
};

// Image made of parts, each with its own error bound and largest intensity.
template <class Part>
class PaintedParts {
   public:
    double peak() const { return brightest().top; }
    double error_at_peak() const { return brightest().error; }  // error bound of U in the brightest part
    double error_bound() const {                                      // largest error bound of I of all parts
        double most = 0.0;
        for (const Part& part : parts_) {
            most = std::max(most, part.error_bound());
        }
        return most;
    }

   protected:
    std::vector<Part> parts_;

   private:
    const Part& brightest() const {
        return *std::max_element(parts_.begin(), parts_.end(), [](const Part& a, const Part& b) { return a.top < b.top; });
    }
};

}  // namespace lommel
