#pragma once
// From expressions to muscles: pull(m) = 1 − Π over expressions (1 − amount(expression, m) · strength).

#include <mien/face_model.h>

#include <span>
#include <vector>

namespace mien {

/// The pull of every muscle, in [0, 1].
///   values   of the model's channels
///   held     for each channel, whether a setting or a running clip holds it
///
/// A muscle whose own channel is held has that value, whatever the expressions say. The others are mixed by
/// the law, with the product in the model's order, so that the order in which expressions were set changes
/// no bit. An expression has a left and a right half; muscles without a side get their mean.
void muscle_pulls(const FaceModel& model, std::span<const double> values,
                  std::span<const char> held, std::vector<double>& pulls);

/// Adds what expressions do to other channels: value += amount · strength.
void move_channels(const FaceModel& model, std::span<double> values);

}  // namespace mien
