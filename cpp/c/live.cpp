// Live depth in C: tables from a file, frames in, depth out.
#include "coded.hpp"
#include "lommel/focal/file.hpp"

using coding::coded;
using coding::require;

struct lommel_live {
    lommel::FocalCamera camera;
    std::size_t height, width;
};

lommel_live* lommel_live_new(const void* tables, std::size_t bytes, std::int32_t height, std::int32_t width,
                             std::int32_t threads) noexcept {
    lommel_live* made = nullptr;
    coded([&] {
        require(tables != nullptr, "tables are NULL");
        require(height >= 64 && width >= 64 && height <= 16384 && width <= 16384, "height and width must be 64 to 16384");
        require(threads >= 1 && threads <= 1024, "threads must be 1 to 1024");
        const lommel::FocalFile file(tables, bytes);
        const auto rows = static_cast<std::size_t>(height), columns = static_cast<std::size_t>(width);
        made = new lommel_live{{file, rows, columns, static_cast<std::size_t>(threads)}, rows, columns};
    });
    return made;
}

void lommel_live_free(lommel_live* live) noexcept { delete live; }

int lommel_live_size(const lommel_live* live, std::int32_t* frames, std::int32_t* down, std::int32_t* across) noexcept {
    return coded([&] {
        require(live != nullptr && frames != nullptr && down != nullptr && across != nullptr, "a pointer is NULL");
        *frames = static_cast<std::int32_t>(live->camera.frames());
        *down = static_cast<std::int32_t>(live->camera.down());
        *across = static_cast<std::int32_t>(live->camera.across());
    });
}

int lommel_live_frames(lommel_live* live, const void* const* frames, std::int32_t bits, std::int32_t stride, float* depth,
                       float* errors, float* misfit) noexcept {
    return coded([&] {
        require(live != nullptr && frames != nullptr && depth != nullptr && errors != nullptr && misfit != nullptr,
                "a pointer is NULL");
        require(bits == 8 || bits == 16, "bits must be 8 or 16");
        require(stride >= 0 && static_cast<std::size_t>(stride) >= live->width, "stride must be the width or more");
        for (std::size_t i = 0; i < live->camera.frames(); ++i) {
            require(frames[i] != nullptr, "a frame is NULL");
        }
        live->camera.take(frames, bits == 16, static_cast<std::size_t>(stride), depth, errors, misfit);
    });
}

int lommel_live_sharp(lommel_live* live, float* image) noexcept {
    return coded([&] {
        require(live != nullptr && image != nullptr, "a pointer is NULL");
        live->camera.sharpen(image);
    });
}
