/// \file
/// Values that know how to be written to a stream, as text: vectors and matrices of Eigen.
#pragma once

#include <locale>
#include <sstream>
#include <string>

namespace equilibria {

/// With every digit of its numbers.
template <class T>
std::string streamed(const T& value) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(17);
    out << value;
    return out.str();
}

}  // namespace equilibria
