/// \file
/// Everything, for programs and experiments; a library's own headers include what they use.
#pragma once

#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/version.hpp>
