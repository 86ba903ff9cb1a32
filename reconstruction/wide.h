#pragma once
// Purpose: GLISSON_WIDE before a function compiles it twice, for every x86-64 and for machines with 256-bit instructions; the
// machine's own is chosen at program start. No multiplication is fused with an addition (-ffp-contract=off), so both give the same
// bytes. Left out under sanitizers, whose own start comes too late for the choice.

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(GLISSON_NO_WIDE)
#define GLISSON_WIDE [[gnu::target_clones("avx2", "default")]]
#else
#define GLISSON_WIDE
#endif
