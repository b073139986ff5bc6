#include "rotating_chain/chain_definition.hpp"

template ChainResult enumerate_chain<1>(const Chain&, const Options&);
template ChainResult enumerate_chain<3>(const Chain&, const Options&);
template ChainResult enumerate_chain<5>(const Chain&, const Options&);
template ChainResult enumerate_chain<7>(const Chain&, const Options&);
