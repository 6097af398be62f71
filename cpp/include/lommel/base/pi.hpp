// pi.
#pragma once

namespace lommel {

constexpr double pi = 3.14159265358979323846;

}  // namespace lommel
