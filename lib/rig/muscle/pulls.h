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

/// Applies what expressions do to each other: binary ones are 0 or 1, and some override those of a group, by the laws of
/// VRM 1.0. An expression does not override its own group.
void settle_expressions(const FaceModel& model, std::span<double> values);

/// Adds what expressions do to other channels: value += amount · strength; of channels that join, value = 1 − (1 − value)
/// (1 − amount · strength). An amount per another expression is divided by that one's strength, by 0.1 at least, and is 1 at
/// most.
void move_channels(const FaceModel& model, std::span<double> values);

}  // namespace mien
