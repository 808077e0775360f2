#pragma once
// The emotions that columns of data and factors of an experiment move.

#include <array>
#include <string_view>

namespace mien::command {

inline constexpr std::array<std::string_view, 6> kFeelings{"joy",  "sadness", "anger",
                                                           "fear", "disgust", "surprise"};

}  // namespace mien::command
