/// \file
/// Header-only, or compiled once: what is no template and no user's is declared in its header, and defined in a header
/// of its own (detail/*_definitions.hpp), which the former includes, or the library `equilibria::compiled` alone, whose
/// users get EQUILIBRIA_COMPILED defined.
///
/// A program is one or the other: its units must not be mixed, since a class that is defined by both would be compiled
/// with two sets of flags. On ELF systems the linker sees to that: each unit brings the section group of a name, of
/// which the linker keeps the first, with one of two symbols, and refers to the symbol of its own kind.
#pragma once

#ifdef EQUILIBRIA_COMPILED
/// What a definition that is no template begins with: `inline` in header-only use, nothing in the library's own units.
#define EQUILIBRIA_INLINE
/// The name of the symbol that tells the kinds of units apart; for this header alone.
#define EQUILIBRIA_KIND_OF_UNIT "this_unit_uses_equilibria_compiled_but_another_one_is_header_only"
#else
#define EQUILIBRIA_INLINE inline
#define EQUILIBRIA_KIND_OF_UNIT "this_unit_uses_equilibria_header_only_but_another_one_is_compiled"
#endif

#ifdef __ELF__
// clang-format off
__asm__(".ifndef " EQUILIBRIA_KIND_OF_UNIT "\n"  // link-time optimisation puts several units into one
        ".pushsection .rodata.equilibria_kind,\"aG\",@progbits,equilibria_kind_of_unit,comdat\n"
        ".globl " EQUILIBRIA_KIND_OF_UNIT "\n"
        ".hidden " EQUILIBRIA_KIND_OF_UNIT "\n"
        EQUILIBRIA_KIND_OF_UNIT ":\n"
        ".byte 0\n"
        ".popsection\n"
        ".pushsection .data.rel.ro.equilibria_reference,\"aw\",@progbits\n"
        ".dc.a " EQUILIBRIA_KIND_OF_UNIT "\n"
        ".popsection\n"
        ".endif\n");
// clang-format on
#endif
#undef EQUILIBRIA_KIND_OF_UNIT
