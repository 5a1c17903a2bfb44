#include "wavefront/columns.h"

#include "base/hash.h"

namespace ctpbench {

std::uint64_t HitStorage::hash() const {
    return hash_vector(v_, hash_vector(u_, hash_vector(primitive_, hash_vector(t_))));
}

std::uint64_t ImageStorage::hash() const {
    return hash_vector(columns_[2], hash_vector(columns_[1], hash_vector(columns_[0])));
}

}  // namespace ctpbench
