// Depth maps and sharp images from focal stacks of frames.
#include <array>
#include <cstring>
#include <optional>
#include <vector>

#include <nanobind/stl/array.h>
#include <nanobind/stl/optional.h>

#include "lommel/focal/scale.hpp"
#include "lommel/focal/stream.hpp"

#include "python.hpp"

using namespace bindings;

namespace {

using Frame = nb::ndarray<nb::ro, nb::ndim<2>, nb::device::cpu>;
using Known = nb::ndarray<const std::uint8_t, nb::ndim<2>, nb::device::cpu>;

// Convert a frame of uint8, uint16 or float32, of at least height x width pixels, for the core.
lommel::FocalFrame frame_of(const Frame& one, float full, const std::optional<Known>& known, std::size_t height,
                            std::size_t width) {
    const auto fits = [&](const auto& array) {
        return array.shape(0) >= height && array.shape(1) >= width && array.stride(1) == 1 && array.stride(0) >= 0;
    };
    require(!known || fits(*known), "known pixels have the planned size, those of a row next to one another");
    require(fits(one), "frames have the planned size, the pixels of a row next to one another");
    using Kind = lommel::FocalFrame::Kind;
    const bool bytes = one.dtype() == nb::dtype<std::uint8_t>(), floats = one.dtype() == nb::dtype<float>();
    require(bytes || floats || one.dtype() == nb::dtype<std::uint16_t>(), "frames are uint8, uint16 or float32");
    lommel::FocalFrame frame{};
    frame.kind = floats ? Kind::floats : bytes ? Kind::bytes : Kind::words;
    frame.data = one.data();
    frame.stride = static_cast<std::size_t>(one.stride(0));
    frame.full = full;
    frame.known = known ? known->data() : nullptr;
    frame.known_stride = known ? static_cast<std::size_t>(known->stride(0)) : 0;
    return frame;
}

class Scale {
   public:
    Scale(std::size_t height, std::size_t width, double scale, std::size_t threads) : scale_(height, width, scale, threads) {}

    void operator()(const nb::object& frame, float full, const std::optional<Known>& known, Out<float, 2> out) {
        const lommel::FocalFrame one = frame_of(nb::cast<Frame>(frame), full, known, scale_.height(), scale_.width());
        released([&] { scale_(one, out.data()); });
    }

   private:
    lommel::FocalScale scale_;
};

class Stream {
   public:
    // residuals[channel][count][frame][term]; forms and statistics as of FocalCandidates, for all channels together.
    //
    // sizes: height and width after binning, binning, pixels along a block (after binning), depths per block along an axis,
    // blur radius in pixels, strips.
    //
    // numbers: variance of a pixel without light, pixels in a window, vergence of the first candidate and the step between
    // candidates, smallest and largest valid position, largest standard error of a reliable depth.
    Stream(const std::array<std::size_t, 7>& sizes, In<float, 1> taps, In<float, 4> residuals, In<float, 3> images,
           In<float, 1> weights, In<float, 2> forms, In<float, 2> statistics, const std::array<float, 7>& numbers) {
        const auto [height, width, binning, side, fine, blur, strips] = sizes;
        require(statistics.shape(0) == lommel::FocalCandidates::rows && statistics.shape(1) == forms.shape(0),
                "eight rows of statistics, one number a candidate");
        const std::size_t channels = residuals.shape(0), count = residuals.shape(1), frames = residuals.shape(2),
                          terms = residuals.shape(3);
        lommel::FocalPlan plan{height,
                               width,
                               binning,
                               channels,
                               frames,
                               {terms - 1, taps.size() - 1, {}},
                               residuals.data(),
                               count,
                               images.data(),
                               images.shape(0),
                               {side, {weights.data(), weights.data() + weights.size()}},
                               fine,
                               blur,
                               strips};
        std::copy_n(taps.data(), taps.size(), plan.taps.values);
        const lommel::FocalCandidates given{forms.shape(0), forms.data(), statistics.data(), numbers[0], numbers[1],
                                            numbers[2],     numbers[3],   numbers[4],        numbers[5], numbers[6]};
        stream_.emplace(plan, &given);
        frames_.resize(channels * frames);
    }

    // Sums of raw values over pixels known in all frames, in 8 x 8 parts of the frames; the last entry is the number of these
    // pixels.
    void sums(const nb::typed<nb::sequence, nb::object>& frames, float full, const std::optional<Known>& known,
              Out<double, 3> out) {
        look_at(frames, full, known);
        released([&] { stream_->sum(frames_.data(), out.data()); });
    }

    // Frames of uint8, uint16 or float32; gains: six per frame, see FocalFrame; offset: dark level; full: saturation level.
    void take(const nb::typed<nb::sequence, nb::object>& frames, const In<float, 2>& gains, float offset, float full,
              const std::optional<Known>& known) {
        look_at(frames, full, known);
        for (std::size_t i = 0; i < frames_.size(); ++i) {
            frames_[i].offset = offset;
            std::copy_n(gains.data() + 6 * i, 6, frames_[i].gain);
        }
        released([&] { stream_->take(frames_.data()); });
    }

    // Depth, standard error and misfit of blocks; NaN and infinity where unknown.
    void depths(Out<float, 2> depth, Out<float, 2> errors, Out<float, 2> misfit) {
        released([&] {
            stream_->search();
            stream_->depths(depth.data(), errors.data(), misfit.data());
        });
    }

    // Position in candidates, its standard error, and misfit.
    void places(Out<float, 2> position, Out<float, 2> errors, Out<float, 2> misfit) {
        released([&] {
            stream_->search();
            const lommel::FocalPlace* const places = stream_->places();
            for (std::size_t i = 0; i < position.size(); ++i) {
                position.data()[i] = places[i].position;
                errors.data()[i] = places[i].error;
                misfit.data()[i] = places[i].misfit;
            }
        });
    }

    // Positions of blocks in candidates; unknown ones are filled from their surroundings.
    void positions(Out<float, 2> out) const { std::memcpy(out.data(), stream_->filled(), out.size() * sizeof(float)); }

    // Mix the kept images at positions of blocks of `side` pixels (after binning), with factors[candidate][image].
    void mix(const In<float, 2>& positions, std::size_t side, const In<float, 2>& factors, Out<float, 2> out) {
        released([&] {
            stream_->mix(positions.data(), positions.shape(0), positions.shape(1), side, factors.data(), factors.shape(0),
                         out.data());
        });
    }

   private:
    void look_at(const nb::typed<nb::sequence, nb::object>& frames, float full, const std::optional<Known>& known) {
        const lommel::FocalPlan& plan = stream_->plan();
        require(nb::len(frames) == plan.planes(), "as many frames as planned");
        for (std::size_t i = 0; i < plan.planes(); ++i) {
            frames_[i] =
                frame_of(nb::cast<Frame>(frames[i]), full, known, plan.height * plan.binning, plan.width * plan.binning);
        }
    }

    std::optional<lommel::FocalStream> stream_;
    std::vector<lommel::FocalFrame> frames_;
};

}  // namespace

void bindings::define_focal(nb::module_& m) {
    nb::class_<Scale>(m, "FocalScale", "Frames enlarged about their middle.")
        .def(nb::init<std::size_t, std::size_t, double, std::size_t>(), "height"_a, "width"_a, "scale"_a, "threads"_a)
        .def("__call__", &Scale::operator(), "frame"_a, "full"_a, "known"_a.none(), "out"_a,
             "Write a frame: NaN for what depends on unknown pixels.");
    nb::class_<Stream>(m, "FocalStream", "Depth and sharp images of frames that differ in focus.")
        .def(nb::init<const std::array<std::size_t, 7>&, In<float, 1>, In<float, 4>, In<float, 3>, In<float, 1>, In<float, 2>,
                      In<float, 2>, const std::array<float, 7>&>(),
             "sizes"_a, "taps"_a, "residuals"_a, "images"_a, "weights"_a, "forms"_a, "statistics"_a, "numbers"_a)
        .def("sums", &Stream::sums, "frames"_a, "full"_a, "known"_a.none(), "out"_a, "Write sums of known pixels.")
        .def("take", &Stream::take, "frames"_a, "gains"_a, "offset"_a, "full"_a, "known"_a.none(), "Filter frames.")
        .def("depths", &Stream::depths, "depth"_a, "errors"_a, "misfit"_a, "Write depth, its standard error and misfit.")
        .def("places", &Stream::places, "position"_a, "errors"_a, "misfit"_a, "Write positions, their errors and misfit.")
        .def("positions", &Stream::positions, "out"_a, "Write positions of blocks, filled in.")
        .def("mix", &Stream::mix, "positions"_a, "side"_a, "factors"_a, "out"_a, "Write a sum of images.");
}
