// The constant pi, which the standard library has only since C++20.
#pragma once

namespace lommel {

constexpr double pi = 3.14159265358979323846;

}  // namespace lommel
