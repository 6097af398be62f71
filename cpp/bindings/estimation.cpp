// Likelihood of star images, and its derivatives with respect to the parameters of the pupil.
#include <deque>
#include <utility>
#include <vector>

#include "lommel/base/parallel.hpp"
#include "lommel/base/tasks.hpp"
#include "lommel/estimation/likelihood.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

template <class T>
std::pair<Out<double, 3>, Out<double, 4>> star_likelihood(const nb::typed<nb::list, nb::object>& images,
                                                          const In<double, 3>& light, const In<double, 3>& star, int threads) {
    const std::size_t sets = light.shape(0), count = light.shape(2), size = sets * count, pixels = star.shape(2);
    require(light.shape(1) == 2 && star.shape(0) == 4 && star.shape(1) == count && threads >= 0,
            "light must be (sets, 2, images), star (4, images, pixels)");
    std::deque<Buffer<const T>> arrays;
    for (const nb::handle image : images) {
        const Buffer<const T>& array = arrays.emplace_back(image);
        std::size_t values = 1;
        for (std::size_t axis = 0; array && axis < array.ndim(); ++axis) {
            values *= static_cast<std::size_t>(array.shape()[axis]);
        }
        require(array && values == size * pixels, "images must be of one type and as large as those of the star");
    }
    require(!arrays.empty(), "images must not be empty");
    const std::size_t rows = arrays.size() + 2;
    auto products = new_array<double, 4>({sets, count, rows, rows});
    auto numbers = new_array<double, 3>({3, sets, count});
    released([&] {
        const double microseconds = 1e-4 * static_cast<double>(rows * rows * pixels * size);
        lommel::parallel_for(size, lommel::worthwhile_threads(threads, microseconds), [&](std::size_t, std::size_t image) {
            const std::size_t set = image / count, one = image % count;
            std::vector<const T*> from;
            for (const Buffer<const T>& array : arrays) {
                from.push_back(array.data() + image * pixels);
            }
            const auto part = [&](std::size_t k) { return star.data() + (k * count + one) * pixels; };
            const double* const own = light.data() + 2 * set * count + one;
            const lommel::StarLikelihood found = lommel::star_likelihood<T>(
                {part(0), part(1), part(2), part(3)}, pixels, from, own[0], own[count], products.data() + image * rows * rows);
            const double all[] = {found.deviance, found.expected, found.spread};
            for (std::size_t k = 0; k < 3; ++k) {
                numbers.data()[k * size + image] = all[k];
            }
        });
    });
    return {numbers, products};
}

}  // namespace

void bindings::define_estimation(nb::module_& m) {
    for_both([&](auto pixel) {
        using T = decltype(pixel);
        m.def(sizeof(T) == 4 ? "star_likelihood_single" : "star_likelihood_double", &star_likelihood<T>, "images"_a, "light"_a,
              "star"_a, "threads"_a,
              "Deviance, expected chi2 and its variance, (3, sets, images), of counts given images and their derivatives, and "
              "the "
              "products of these, 1 and the residual over standard deviations, (sets, images, k + 2, k + 2).");
    });
}
