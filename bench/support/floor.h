#pragma once

namespace mien::bench {

/// Registers what the machine can do at best, per instruction set: ns per fused multiply-add,
/// division and square root of one float lane, all lanes busy ("floor fma/AVX3", …).
void register_floor();

}  // namespace mien::bench
