#pragma once
// Commands that are steps of another one's work.

#include <mien/progress.h>

#include <string>

namespace mien::command {

/// While one lives, commands of this process complain with its address before their own words, print nothing, and their
/// progress is a share of the whole. One at a time; on the thread that runs the commands.
class OuterWork {
 public:
  /// `whole`: is told how far everything is, which goes from `from` to `to` meanwhile.
  OuterWork(std::string where, Progress whole, double from, double to);
  OuterWork(const OuterWork&) = delete;
  OuterWork& operator=(const OuterWork&) = delete;
  ~OuterWork();

  /// Null: commands are on their own.
  static const OuterWork* present();

  const std::string& where() const { return where_; }
  /// An inner command has done this share of its step.
  bool tell(double done) const { return whole_(from_ + (to_ - from_) * done); }

 private:
  std::string where_;
  Progress whole_;
  double from_, to_;
};

}  // namespace mien::command
