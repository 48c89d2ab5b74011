// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef mortar_contact_mortar_vector_clones_h
#define mortar_contact_mortar_vector_clones_h

/**
 * Before a hot function: a second version of it for processors with AVX2,
 * chosen when the library is loaded. Without fused multiplications, so both
 * give the same numbers to the last bit.
 */
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#  define MORTAR_CONTACT_VECTOR_CLONES \
    __attribute__((target_clones("avx2", "default")))
#else
#  define MORTAR_CONTACT_VECTOR_CLONES
#endif

#endif
