// Compiles the likelihood of star images.
#include "lommel/estimation/likelihood.hpp"

template lommel::StarLikelihood lommel::star_likelihood<float>(const lommel::StarCounts&, std::size_t,
                                                               const std::vector<const float*>&, double, double, double*);
template lommel::StarLikelihood lommel::star_likelihood<double>(const lommel::StarCounts&, std::size_t,
                                                                const std::vector<const double*>&, double, double, double*);
