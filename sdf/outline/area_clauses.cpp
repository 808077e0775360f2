#include "sdf/outline/area_clauses.h"

#include <algorithm>

namespace mien {

/// The opposite of the last operand: of a disjunction the conjunction of opposites, and the other way round.
bool AreaClauses::turn_around(Part& part) {
  const auto from = std::ptrdiff_t(part.first);
  if (part.kind == Kind::all &&
      std::find(begins_.begin() + from, begins_.end(), 0) != begins_.end())
    return false;
  for (std::size_t i = part.first; i < literals_.size(); ++i) literals_[i] = ~literals_[i];
  if (part.kind == Kind::literal) return true;
  const bool any = part.kind == Kind::any;
  std::fill(begins_.begin() + from, begins_.end(), char(any));
  begins_[part.first] = 1;
  part.kind = any ? Kind::all : Kind::any;
  return true;
}

bool AreaClauses::read(std::span<const AreaStep> program, bool opposite) {
  literals_.clear(), begins_.clear(), parts_.clear();
  for (const AreaStep& step : program) {
    switch (step.kind) {
      case AreaStep::Kind::outline:
        parts_.push_back({Kind::literal, literals_.size()});
        literals_.push_back(opposite ? ~step.outline : step.outline), begins_.push_back(1);
        break;
      case AreaStep::Kind::nothing:
        return false;
      case AreaStep::Kind::not_:
        if (!turn_around(parts_.back())) return false;
        break;
      case AreaStep::Kind::and_:
      case AreaStep::Kind::or_: {
        const Part last = parts_.back();
        parts_.pop_back();
        if ((step.kind == AreaStep::Kind::and_) != opposite) {
          parts_.back().kind = Kind::all;
          break;
        }
        if (last.kind == Kind::all || parts_.back().kind == Kind::all) return false;
        parts_.back().kind = Kind::any;
        begins_[last.first] = 0;
        break;
      }
    }
  }
  return parts_.size() == 1;
}

}  // namespace mien
