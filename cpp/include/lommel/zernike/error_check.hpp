// Error control of an image: from a preview of the field, and part by part from the values computed.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/limits.hpp"

namespace lommel {

// How bright it is at some distances, rising.
struct Looks {
    std::vector<double> v, bright;  // of each look, the largest I

    // The largest of those from one distance to another, and of one more on either side.
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

// The error of U that makes one of `all` in I where that is `intensity`, or U so many times `brighter`.
inline double allowed_error(double all, double intensity, double brighter) {
    const double u = brighter * std::sqrt(intensity);
    return all / (u + std::sqrt(u * u + all));
}

struct PaintedPart {
    double error = 0.0, top = 0.0;  // of U, proven; and the largest I
    double wrong() const { return intensity_error(std::sqrt(top), error); }
};

// An image of such parts.
template <class Part>
class PaintedParts {
   public:
    double peak() const { return brightest().top; }
    double error_at_peak() const { return brightest().error; }  // of U
    double wrong() const {                                      // proven error of I
        double most = 0.0;
        for (const Part& part : parts_) {
            most = std::max(most, part.wrong());
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
