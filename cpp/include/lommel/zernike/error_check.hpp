// Error control of an image: allowed errors from a preview of the field, then error bounds from the computed values.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "lommel/limits.hpp"

namespace lommel {

// Preview of the intensity at increasing distances from the axis.
struct Looks {
    std::vector<double> v, bright;  // bright: largest sampled I at each distance

    // Largest intensity between two distances, including the next sample on either side.
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

// Error of U that causes the error `all` of I at this intensity, if |U| may be larger by the factor `brighter`.
inline double allowed_error(double all, double intensity, double brighter) {
    const double u = brighter * std::sqrt(intensity);
    return all / (u + std::sqrt(u * u + all));
}

struct PaintedPart {
    double error = 0.0, top = 0.0;  // error bound of U; largest computed I
    double error_bound() const { return intensity_error(std::sqrt(top), error); }
};

// Image made of parts with separate error bounds.
template <class Part>
class PaintedParts {
   public:
    double peak() const { return brightest().top; }
    double error_at_peak() const { return brightest().error; }  // error bound of U there
    double error_bound() const {                                      // error bound of I
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
