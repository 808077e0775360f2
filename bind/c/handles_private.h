#pragma once
// What the handles of the C interface hold.

#include <mien/bound_motion.h>
#include <mien/effect.h>
#include <mien/npy_basis.h>
#include <mien/piece_drawer.h>
#include <mien/poser.h>
#include <mien/renderer.h>
#include <mien/scene.h>
#include <mien/steady_frames.h>
#include "bind/c/mien_c.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

struct mien_texts {
  std::vector<std::string> all;
};

struct mien_face {
  mien::Face face;
  std::atomic<int> owners = 1;

  explicit mien_face(mien::Face of) : face(std::move(of)) {}

  /// Made when it is asked for first; threads may ask at once.
  const std::vector<mien::SettableName>& names() const {
    std::call_once(named_, [&] { names_ = mien::settable_names(face); });
    return names_;
  }

 private:
  mutable std::once_flag named_;
  mutable std::vector<mien::SettableName> names_;
};

struct mien_pose {
  mien::Face face;
  mien::Pose pose;

  explicit mien_pose(const mien::Face& of) : face(of) {}

  /// A new value replaces the one that was held before, so that poses of an animation do not grow.
  void hold(mien::Setting setting) {
    std::erase_if(pose.settings, [&](const mien::Setting& one) {
      return one.control == setting.control && one.index == setting.index &&
             one.values.size() == setting.values.size();
    });
    pose.settings.push_back(std::move(setting));
  }

  const mien::Face& posed() {
    if (!poser_) poser_.emplace(face);
    return poser_->pose(pose);
  }

  /// What the muscles pull after posed().
  std::span<const double> pulls() const { return poser_->pulls(); }

 private:
  std::optional<mien::Poser> poser_;
};

struct mien_motion {
  std::shared_ptr<const mien::Motion> motion;
  std::vector<std::string> told;

  /// The motion for a face. Those of the few faces that asked last are kept, since animations ask again for every frame;
  /// threads may ask at once.
  std::shared_ptr<const mien::Motion> bound_to(const mien::Face& face) const {
    const std::lock_guard lock(binding_);
    for (const auto& [model, bound] : bound_)
      if (model.lock() == face.model) return bound;
    constexpr std::size_t kMostBound = 4;
    if (bound_.size() == kMostBound) bound_.erase(bound_.begin());
    bound_.emplace_back(face.model, mien::bind_motion(*motion, face).motion);
    return bound_.back().second;
  }

 private:
  mutable std::mutex binding_;
  mutable std::vector<
      std::pair<std::weak_ptr<const mien::FaceModel>, std::shared_ptr<const mien::Motion>>>
      bound_;
};

struct mien_steadier {
  mien::SteadyFrames frames;
};

struct mien_scene {
  mien::Scene scene;
};

struct mien_renderer {
  mien::Renderer renderer;
  mien::RenderStats last = {};  ///< of the last picture
};

struct mien_effects {
  std::vector<mien::Effect> all;
};

struct mien_basis {
  mien::BasisFile file;
};

struct mien_pieces {
  mien::PieceDrawer drawer;
  mien::PixelRect whole;
  mien::Depth depth;
};

namespace mien::c {

/// A list of texts for the caller.
mien_texts* new_texts(std::vector<std::string> texts);

}  // namespace mien::c
