// Enumerations that several files of this folder use are compiled in one of them each: chain_1_test.cpp to
// chain_5_test.cpp and two_links_degenerate_test.cpp.
#pragma once

#include "support/enumeration.hpp"

#define TESTS_ENUMERATION_OF(Model)                                                            \
    equilibria::RootSet<Model> equilibria::enumerate<Model, equilibria::StartKind::reflected>( \
        const equilibria::Parameters<Model>&, const equilibria::EnumerateOptions&)

extern template TESTS_ENUMERATION_OF(tests::Chain<1>);
extern template TESTS_ENUMERATION_OF(tests::Chain<2>);
extern template TESTS_ENUMERATION_OF(tests::Chain<3>);
extern template TESTS_ENUMERATION_OF(tests::Chain<4>);
extern template TESTS_ENUMERATION_OF(tests::Chain<5>);
extern template TESTS_ENUMERATION_OF(equilibria::mechanisms::TwoLinkChain);
