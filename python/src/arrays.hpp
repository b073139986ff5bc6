/// \file
/// numpy's arrays of the library's, and back.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <equilibria/core/error.hpp>
#include <equilibria/core/sized_array.hpp>

namespace equilibria::python {

using Numbers = pybind11::array_t<double, pybind11::array::c_style | pybind11::array::forcecast>;

/// entry(thing) of each of the things.
template <class T, class Things, class Entry>
pybind11::array_t<T> column(const Things& things, const Entry& entry) {
    pybind11::array_t<T> y(static_cast<pybind11::ssize_t>(things.size()));
    T* to = y.mutable_data();
    for (const auto& thing : things) *to++ = static_cast<T>(entry(thing));
    return y;
}

/// A row of `width` entries row(thing)[0 ..] of each of the things.
template <class T, class Things, class Row>
pybind11::array_t<T> rows(const Things& things, std::size_t width, const Row& row) {
    pybind11::array_t<T> y({things.size(), width});
    T* to = y.mutable_data();
    for (const auto& thing : things) {
        const auto& entries = row(thing);
        for (std::size_t k = 0; k < width; ++k)
            *to++ = static_cast<T>(entries[static_cast<decltype(entries.size())>(k)]);
    }
    return y;
}

template <class T>
pybind11::array_t<T> array_of(const std::vector<T>& values) {
    return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

inline RuntimeArray<double> runtime_array(const Numbers& values, const char* name) {
    require(values.ndim() == 1, name, values.ndim(), "must have one dimension");
    RuntimeArray<double> y(static_cast<int>(values.size()));
    for (int k = 0; k < y.size(); ++k) y[k] = values.data()[k];
    return y;
}

}  // namespace equilibria::python
