#include "oracle/fresnel.hpp"

#include <cmath>

namespace fringe::oracle {

double reflectance(double cosine, std::complex<double> relativeIndex) {
    const std::complex<double> sineBehind = std::sqrt(1.0 - cosine * cosine) / relativeIndex;
    const std::complex<double> cosineBehind = std::sqrt(1.0 - sineBehind * sineBehind);
    const auto perpendicular =
        (cosine - relativeIndex * cosineBehind) / (cosine + relativeIndex * cosineBehind);
    const auto parallel = (relativeIndex * cosine - cosineBehind) / (relativeIndex * cosine + cosineBehind);
    return 0.5 * (std::norm(perpendicular) + std::norm(parallel));
}

std::optional<dvec3> refracted(const dvec3& direction, const dvec3& normal, double relativeIndex) {
    // The part along the interface is all that the index changes; what is left of a unit vector goes through.
    const dvec3 along = (direction - glm::dot(direction, normal) * normal) / relativeIndex;
    const double squaredRest = 1.0 - glm::dot(along, along);
    if (squaredRest <= 0.0) return {};
    return along - std::sqrt(squaredRest) * normal;
}

}  // namespace fringe::oracle
