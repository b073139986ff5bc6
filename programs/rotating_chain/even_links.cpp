#include "rotating_chain/chain_definition.hpp"

template ChainResult enumerate_chain<2>(const Chain&, const Options&);
template ChainResult enumerate_chain<4>(const Chain&, const Options&);
template ChainResult enumerate_chain<6>(const Chain&, const Options&);
template ChainResult enumerate_chain<8>(const Chain&, const Options&);
