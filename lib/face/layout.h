#pragma once
// The layout of the face vector: its slices, in order and by name.
//
//   const int spine = layout.add("brow.left/spine/0", SliceKind::point, 2);
//   vector[layout[spine].begin]      // its x

#include <mien/api.h>
#include <mien/face.h>
#include <mien/name_table.h>
#include <mien/names.h>
#include <mien/slice.h>

#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <string_view>
#include <vector>

namespace mien {

class MIEN_API Layout {
 public:
  /// Appends a slice with the range and rule of its kind, and returns its index. The name must be new.
  int add(std::string_view name, SliceKind kind, int size) { return add({name}, kind, size); }
  /// The same for a name in parts: {"brow.left", "/", "spine"}.
  int add(std::initializer_list<std::string_view> name, SliceKind kind, int size);

  /// The index of the slice of that name, or −1.
  int find(std::string_view name) const;

  const std::vector<Slice>& slices() const { return slices_; }
  const Slice& operator[](int slice) const { return slices_[std::size_t(slice)]; }
  std::size_t size() const { return size_; }  ///< numbers in the face vector

  /// No number of a face may be larger than this, whatever its rule.
  double largest = 1e9;

 private:
  Names names_;
  std::vector<Slice> slices_;
  NameTable table_;
  std::size_t size_ = 0;
};

/// Brings every number of `vector` into its slice's range by the slice's rule. NaN is replaced by the value
/// in `rest`. Numbers in range keep every bit.
MIEN_API void apply_rules(const Layout& layout, const FaceVector& rest, FaceVector& vector);

}  // namespace mien
