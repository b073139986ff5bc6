// A number, or a pack of numbers, that the engine can be run over to see where its work goes: it counts its operations
// by the part of a step that they belong to, or says only which part is at work, for a clock that looks at it.
#pragma once

#include <array>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include <equilibria/core/lanes.hpp>
#include <equilibria/core/linear_solve.hpp>
#include <equilibria/evaluation/table_evaluation.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/homotopy/tracking.hpp>

namespace watched {

/// The parts of a step. The driver copies points, accepts steps, ends paths and fills lanes again; starts are the
/// points that it fills them with; points are moved, and their corrections measured.
enum Part { driver, starts, points, values, jacobians, series, factors, solves, predictor, control, n_parts };
inline constexpr std::array<std::string_view, n_parts> part_names{
    "driver", "starts", "points", "values", "Jacobians", "series", "factors", "solves", "predictor", "control"};

/// The part that is at work.
inline volatile std::sig_atomic_t at_work = driver;

/// A part, as long as this lives.
class In {
public:
    explicit In(Part part) : before_(at_work) { at_work = part; }
    ~In() { at_work = before_; }
    In(const In&) = delete;

private:
    std::sig_atomic_t before_;
};

struct Operations {
    std::uint64_t additions = 0, multiplications = 0, divisions = 0, roots = 0, comparisons = 0;

    std::uint64_t flops() const { return additions + multiplications + divisions + roots; }
};
/// Of each part; and how often the parts that are called by name were.
inline std::array<Operations, n_parts> operations;
inline std::array<std::uint64_t, n_parts> calls;
/// Steps that were judged, of packs or of scalars, and those of scalars that were refused.
inline std::uint64_t judged, refused;

inline void count(std::uint64_t Operations::* what) { ++(operations[static_cast<std::size_t>(at_work)].*what); }

template <class V>
struct ScalarOf {
    using type = V;
};
template <class V>
requires(!std::is_arithmetic_v<V>)
struct ScalarOf<V> {
    using type = std::remove_cvref_t<decltype(V{}[0])>;
};

/// V: double, or the compilers' pack of doubles or floats. Counts: of scalars, whether operations are counted.
template <class V, bool Counts = std::is_arithmetic_v<V>>
struct Watched {
    using Number = typename ScalarOf<V>::type;
    using Mask = decltype(V{} < V{});
    V v;

    constexpr Watched() = default;
    template <class A>
    requires(std::is_arithmetic_v<A> && std::is_arithmetic_v<V>)
    constexpr Watched(A value) : v(static_cast<V>(value)) {}
    template <class A>
    requires std::is_arithmetic_v<V>
    constexpr explicit operator A() const {
        return static_cast<A>(v);
    }

    static constexpr Watched of(const V& value) {
        Watched y;
        y.v = value;
        return y;
    }
    static void tell(std::uint64_t Operations::* what) {
        if constexpr (Counts) count(what);
    }

    friend Watched operator+(const Watched& a, const Watched& b) { return tell(&Operations::additions), of(a.v + b.v); }
    friend Watched operator-(const Watched& a, const Watched& b) { return tell(&Operations::additions), of(a.v - b.v); }
    friend Watched operator*(const Watched& a, const Watched& b) {
        return tell(&Operations::multiplications), of(a.v * b.v);
    }
    friend Watched operator/(const Watched& a, const Watched& b) { return tell(&Operations::divisions), of(a.v / b.v); }
    friend Watched operator-(const Watched& a) { return of(-a.v); }
    friend Mask operator<(const Watched& a, const Watched& b) { return tell(&Operations::comparisons), a.v < b.v; }
    friend Mask operator>(const Watched& a, const Watched& b) { return tell(&Operations::comparisons), a.v > b.v; }
    friend Mask operator>=(const Watched& a, const Watched& b) { return tell(&Operations::comparisons), a.v >= b.v; }
    friend bool operator==(const Watched& a, const Watched& b)
    requires std::is_arithmetic_v<V>
    {
        return a.v == b.v;
    }

    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator+(const Watched& a, A b) {
        return tell(&Operations::additions), of(a.v + static_cast<Number>(b));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator+(A a, const Watched& b) {
        return tell(&Operations::additions), of(static_cast<Number>(a) + b.v);
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator-(const Watched& a, A b) {
        return tell(&Operations::additions), of(a.v - static_cast<Number>(b));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator-(A a, const Watched& b) {
        return tell(&Operations::additions), of(static_cast<Number>(a) - b.v);
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator*(const Watched& a, A b) {
        return tell(&Operations::multiplications), of(a.v * static_cast<Number>(b));
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator*(A a, const Watched& b) {
        return tell(&Operations::multiplications), of(static_cast<Number>(a) * b.v);
    }
    template <class A>
    requires std::is_arithmetic_v<A>
    friend Watched operator/(A a, const Watched& b) {
        return tell(&Operations::divisions), of(static_cast<Number>(a) / b.v);
    }
    friend Watched select(const Mask& mask, const Watched& a, const Watched& b) { return of(mask ? a.v : b.v); }
    friend Watched sqrt(const Watched& a) { return tell(&Operations::roots), of(std::sqrt(a.v)); }
};

/// The numbers of a pack; a scalar has one.
template <class V, bool C>
typename Watched<V, C>::Number lane(const Watched<V, C>& pack, int k) {
    if constexpr (std::is_arithmetic_v<V>)
        return pack.v;
    else
        return pack.v[k];
}
template <class V, bool C>
void set_lane(Watched<V, C>& pack, int k, const typename Watched<V, C>::Number& value) {
    if constexpr (std::is_arithmetic_v<V>)
        pack.v = value;
    else
        pack.v[k] = value;
}
template <class V, bool C>
Watched<V, C> square_root(const Watched<V, C>& a)
requires(!std::is_arithmetic_v<V>)
{
    constexpr int width = static_cast<int>(sizeof(V) / sizeof(typename Watched<V, C>::Number));
    Watched<V, C> y;
    for (int k = 0; k < width; ++k) y.v[k] = std::sqrt(a.v[k]);
    return y;
}

/// What moves a point, and how far it was moved.
template <class V, bool C>
void move_roughly(equilibria::RuntimePoint<Watched<V, C>>& q, const auto& d) {
    const In part(points);
    equilibria::move_roughly<equilibria::RuntimeUnknowns, Watched<V, C>>(q, d);
}
template <class V, bool C>
void correct_roughly(equilibria::RuntimePoint<Watched<V, C>>& q, const auto& d) {
    const In part(points);
    equilibria::correct_roughly<Watched<V, C>>(q, d);
}
template <class V, bool C>
Watched<V, C> correction_size(const equilibria::RuntimePoint<Watched<V, C>>& q, const auto& d) {
    const In part(points);
    return equilibria::correction_size<equilibria::RuntimeUnknowns, Watched<V, C>>(q, d);
}

/// Counts the steps that are judged.
template <class R, int local_order>
struct CountingControl : equilibria::ContractionControl<R, local_order> {
    using Base = equilibria::ContractionControl<R, local_order>;
    using Base::Base;

    equilibria::Verdict<R> judge(const equilibria::Trial<R>& trial) const {
        const equilibria::Verdict<R> y = Base::judge(trial);
        ++judged;
        if constexpr (!equilibria::is_pack<R>) refused += !y.accepted;
        return y;
    }
};
struct CountedTracking : equilibria::PadeTracking {
    template <class R, int local_order>
    using StepControl = CountingControl<R, local_order>;
};

/// And says what it is at.
template <class R>
struct WatchedPredictor : equilibria::PadePredictor<R> {
    using Base = equilibria::PadePredictor<R>;

    static auto change(const auto& taylor, int u, const R& h) {
        const In part(predictor);
        return Base::change(taylor, u, h);
    }
    static R pole(const auto& taylor, int n) {
        const In part(predictor);
        return Base::pole(taylor, n);
    }
};
template <class R, int local_order>
struct WatchedControl : CountingControl<R, local_order> {
    using Base = CountingControl<R, local_order>;
    using Base::Base;

    R longest(const R& pole) const {
        const In part(control);
        return Base::longest(pole);
    }
    R first(const R& pole) const {
        const In part(control);
        return Base::first(pole);
    }
    equilibria::Verdict<R> judge(const equilibria::Trial<R>& trial) const {
        const In part(control);
        return Base::judge(trial);
    }
};
struct WatchedTracking {
    template <class R>
    using Predictor = WatchedPredictor<R>;
    template <class R, int local_order>
    using StepControl = WatchedControl<R, local_order>;
};

/// A homotopy whose evaluation, predictor and step control say when they are at work.
struct WatchedHomotopy : equilibria::TrackedBy<WatchedTracking, equilibria::PolynomialHomotopy> {
    using TrackedBy::TrackedBy;

    template <class R, class Time>
    struct Evaluation : equilibria::PolynomialHomotopy::Evaluation<R, Time> {
        using Base = equilibria::PolynomialHomotopy::Evaluation<R, Time>;
        using Base::Base;

        void value(const auto& q, const Time& t, auto& f) {
            const In part(values);
            ++calls[values];
            Base::value(q, t, f);
        }
        void jacobian(const auto& q, const Time& t, auto& f, auto& j) {
            const In part(jacobians);
            ++calls[jacobians];
            Base::jacobian(q, t, f, j);
        }
        void taylor_right_side(int k, auto& f) {
            const In part(series);
            ++calls[series];
            Base::taylor_right_side(k, f);
        }
        void set_coefficient(int k, const auto& d) {
            const In part(series);
            Base::set_coefficient(k, d);
        }
    };
};

}  // namespace watched

namespace equilibria {

template <class V, bool Counts>
struct LaneTraits<watched::Watched<V, Counts>> {
    using Scalar = typename watched::Watched<V, Counts>::Number;
    static constexpr int width = static_cast<int>(sizeof(V) / sizeof(Scalar));
    using Mask = typename watched::Watched<V, Counts>::Mask;
};

/// Of symmetric matrices alone: those of a system with a potential.
template <class V, bool Counts>
class RuntimeFactorization<watched::Watched<V, Counts>> {
public:
    RuntimeFactorization(int n, bool) : of_(n) {}

    void factor(const auto& a) {
        const watched::In part(watched::factors);
        ++watched::calls[watched::factors];
        of_.factor(a);
    }
    void solve(auto& b) const {
        const watched::In part(watched::solves);
        ++watched::calls[watched::solves];
        of_.solve(b);
    }

private:
    SymmetricFactorization<watched::Watched<V, Counts>> of_;
};

}  // namespace equilibria
