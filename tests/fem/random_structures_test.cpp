// Random structures: what is located on their branches, held against their eigenvalues at many points of each branch.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/loads.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/springs.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/fem/truss.hpp>

#include "support/catch.hpp"

using namespace equilibria;
using namespace equilibria::fem;

namespace {

/// Draws structures; those with an even number have a symmetry.
class Drawer {
public:
    explicit Drawer(int number) : number_(number), random_(static_cast<unsigned>(number)) {}

    /// An arch or a frame whose loads turn with their nodes in a share that is drawn.
    Model draw_with_followers() {
        Model m = number_ % 2 == 0 ? arch() : frame();
        const double share = between(0, 1);
        for (const NodalLoad& load : std::vector<NodalLoad>(m.loads())) {
            m.fix(load.node, {uz, rx, ry});
            m.load(load.node, -share * load.force);
            m.add(FollowerLoad{share * load.force}, {load.node});
        }
        return m;
    }
    Model draw() {
        switch (number_ % 5) {
            case 0: return dome();
            case 1: return truss();
            case 2: return arch();
            case 3: return frame();
            default: return cells();
        }
    }

private:
    double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    int among(int low, int high) { return std::uniform_int_distribution<int>(low, high)(random_); }
    bool symmetric() const { return number_ % 2 == 0; }
    /// A number about 1 that spoils the symmetry, where there is to be none.
    double spoiled() { return symmetric() ? 1 : between(0.9, 1.1); }
    /// Stiffnesses of very different sizes.
    double stiffness() { return std::pow(10.0, between(-3, 4)); }

    /// A shallow dome of bars: rings around an apex, which is loaded.
    Model dome() {
        Model m;
        const int around = among(3, 8), rings = among(1, 3);
        const double rise = between(0.1, 0.4), ea = stiffness();
        const int apex = m.add_node({0, 0, rise});
        std::vector<int> inner(static_cast<std::size_t>(around), apex);
        for (int ring = 1; ring <= rings + 1; ++ring) {
            const double radius = static_cast<double>(ring) / (rings + 1);
            std::vector<int> nodes;
            for (int k = 0; k < around; ++k) {
                const double angle = 2 * std::numbers::pi * (k + 0.5 * (ring % 2)) / around;
                nodes.push_back(m.add_node({radius * std::cos(angle) * spoiled(), radius * std::sin(angle),
                                            rise * (1 - radius * radius) * spoiled()}));
            }
            for (std::size_t k = 0; k < nodes.size(); ++k) {
                const std::size_t next = (k + 1) % nodes.size(), before = (k + nodes.size() - 1) % nodes.size();
                const auto bar = [&](int a, int b) { m.add(Truss<3>(ea, m.at(a), m.at(b)), {a, b}); };
                if (ring <= rings) bar(nodes[k], nodes[next]);
                bar(nodes[k], inner[k]);
                if (ring > 1) bar(nodes[k], inner[ring % 2 == 0 ? before : next]);
                if (ring > rings) m.fix(nodes[k], {ux, uy, uz});
            }
            inner = nodes;
        }
        m.load(apex, {0, 0, -ea});
        return m;
    }
    /// A planar girder of panels on two supports, loaded in its middle or anywhere.
    Model truss() {
        Model m;
        const int panels = 2 * among(1, 20);
        const double height = between(0.3, 1.2), ea = stiffness();
        std::vector<int> low, high;
        for (int k = 0; k <= panels; ++k) {
            const double x = k, arc = 0.1 * height * k * (panels - k);
            low.push_back(m.add_node({x, arc / panels, 0}));
            high.push_back(m.add_node({x, height * spoiled() + arc / panels, 0}));
        }
        const auto bar = [&](int a, int b, double share) { m.add(Truss<2>(ea * share, m.at(a), m.at(b)), {a, b}); };
        for (std::size_t k = 0; k < low.size(); ++k) {
            bar(low[k], high[k], 0.3 * spoiled());
            if (k + 1 == low.size()) continue;
            bar(low[k], low[k + 1], 1);
            bar(high[k], high[k + 1], 1);
            bar(low[k], high[k + 1], 0.5);
            bar(high[k], low[k + 1], 0.5);
        }
        m.fix(low.front(), {ux, uy});
        m.fix(low.back(), {ux, uy});
        m.load(high[symmetric() ? high.size() / 2 : static_cast<std::size_t>(among(1, panels - 1))], {0, -ea, 0});
        return m;
    }
    /// A shallow circular arch of beams on two hinges or clamped, loaded at its crown or beside it.
    Model arch() {
        Model m;
        const double half = between(0.3, 1.4), ei = stiffness(), slender = std::pow(10.0, between(2, 6));
        const PlanarSection section{ei * slender, ei * slender * between(0.3, 1), ei};
        const auto along = [half](double t) {
            const double angle = half * (1 - 2 * t);
            return PlanarSectionFrame{{-std::sin(angle) / half, (std::cos(angle) - std::cos(half)) / half, 0}, angle};
        };
        const auto nodes = add_planar_beam<3>(m, section, along, 2 * among(3, 8));
        const bool clamped = among(0, 1) == 1;
        for (const int end : {nodes.front(), nodes.back()}) {
            m.fix(end, {ux, uy});
            if (clamped) m.fix(end, {rz});
        }
        m.load(nodes[symmetric() ? nodes.size() / 2 : nodes.size() / 3], {0, -ei, 0});
        return m;
    }
    /// A portal frame of some storeys, loaded on its corners.
    Model frame() {
        Model m;
        const int storeys = among(1, 3);
        std::vector<int> left{m.add_node({0, 0, 0})}, right{m.add_node({1, 0, 0})};
        const double ei = stiffness(), slender = std::pow(10.0, between(2, 7));
        for (int k = 1; k <= storeys; ++k) {
            left.push_back(m.add_node({0, static_cast<double>(k), 0}));
            right.push_back(m.add_node({1, k * spoiled(), 0}));
        }
        const auto beam = [&](int a, int b, double share) {
            add_straight_planar_beam<3>(m, {ei * slender, ei * slender, ei * share}, a, b, 2);
        };
        for (std::size_t k = 1; k < left.size(); ++k) {
            beam(left[k - 1], left[k], 1);
            beam(right[k - 1], right[k], spoiled());
            beam(left[k], right[k], std::pow(10.0, between(-1, 1)));
            m.load(left[k], {0, -ei, 0});
            m.load(right[k], {0, -ei, 0});
        }
        for (const int foot : {left[0], right[0]}) {
            m.fix(foot, {ux, uy});
            if (symmetric() || among(0, 1) == 1) m.fix(foot, {rz});
        }
        return m;
    }
    /// Cells in a row that snap one after the other, joined by springs.
    Model cells() {
        Model m;
        const int count = among(2, 6);
        const double rise = between(0.2, 0.6), ea = stiffness();
        int before = -1;
        for (int k = 0; k < count; ++k) {
            const double x = 3.0 * k;
            const int a = m.add_node({x - 1, 0, 0}), top = m.add_node({x, rise * spoiled(), 0}),
                      b = m.add_node({x + 1, 0, 0});
            for (const int end : {a, b}) {
                m.fix(end, {ux, uy});
                m.add(Truss<2>(ea, m.at(end), m.at(top)), {end, top});
            }
            if (before >= 0) m.add(Truss<2>(1e-3 * ea, m.at(before), m.at(top)), {before, top});
            m.load(top, {0, -ea, 0});
            before = top;
        }
        return m;
    }

    int number_;
    std::mt19937 random_;
};

/// Twice the smallest load at which K, linear in p, is singular; where there is none, that which moves the structure by
/// a tenth of its size.
template <class S>
double window_of(const S& s) {
    const Eigen::MatrixXd k = s.tangent(s.initial(), 0);
    const Eigen::FullPivLU<Eigen::MatrixXd> factors(k);
    const Eigen::VectorXd slope = factors.solve(-s.parameter_derivative(s.initial(), 0));
    const double moved = std::sqrt(slope.dot(s.weights(s.initial()).cwiseProduct(slope)));
    const double dp = 1e-4 / moved;
    const Eigen::MatrixXd change = (Eigen::MatrixXd(s.tangent(s.retract(s.initial(), dp * slope), dp)) - k) / dp;
    const Eigen::VectorXcd rates = factors.solve(-change).eigenvalues();
    double rate = 0;
    for (const auto& r : rates)
        if (std::abs(r.imag()) < 1e-6 * std::abs(r)) rate = std::max(rate, r.real());
    return rate * 10 > moved ? 2 / rate : 0.1 / moved;
}

/// Negative eigenvalues; of an unsymmetric K 1 where its determinant is negative, else 0.
template <class S>
int negative(const S& s, const BranchPoint<S>& at) {
    const Eigen::MatrixXd k = s.tangent(at.q, at.p);
    if (!S::symmetric) {
        const Eigen::PartialPivLU<Eigen::MatrixXd> lu(k);
        int sign = static_cast<int>(lu.permutationP().determinant());
        for (const double pivot : lu.matrixLU().diagonal()) sign = pivot < 0 ? -sign : sign;
        return sign < 0;
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(k, Eigen::EigenvaluesOnly);
    return static_cast<int>((eigen.eigenvalues().array() < 0).count()) - s.multipliers();
}

int environment(const char* name, int otherwise) {
    const char* value = std::getenv(name);
    return value ? std::atoi(value) : otherwise;
}

struct Count {
    int events = 0, crossed = 0, unexplained = 0;
};
/// Changes of the number of negative eigenvalues, seen by so many small steps along a branch: from each of its points
/// to the next one, so that no step passes to another branch near by.
template <class S>
int seen(const S& s, const Branch<S>& branch, ContinuationOptions options, int points) {
    const auto& last = branch.points.back();
    if (branch.points.size() < 2) return 0;  // it leaves the window at once
    const double step = last.arc_length / points;
    options.branch.largest_step = step;
    options.branch.first_step = std::min(options.branch.first_step, step);
    options.branch.smallest_step = 1e-6 * options.branch.first_step;
    options.branch.resolution = std::max(options.branch.resolution, options.branch.smallest_step);
    BranchStepper<S> stepper(s, options.branch);
    const auto& first = branch.points.front();
    if (!stepper.start(first.q, first.p, first.tangent.p < 0 ? -1 : 1)) return -1;
    int y = 0, before = negative(s, first), steps = 0;
    for (std::size_t k = 0; k + 1 < branch.points.size(); ++k) {
        const auto& target = branch.points[k + 1];
        BranchPoint<S> at = branch.points[k];
        at.proposed_step = std::min(step, target.arc_length - at.arc_length);
        bool reached = at.proposed_step <= options.branch.smallest_step;  // the window's border, at the point
        if (reached) {
            y += std::abs(negative(s, target) - before);
            before = negative(s, target);
        }
        for (int m = 0; m < 40 * points && !reached; ++m, ++steps) {
            const auto next = stepper.advance(at);
            if (!next) break;
            reached = stepper.dot(stepper.difference(target, next->q, next->p), target.tangent) > -1e-9 * step &&
                      stepper.length(stepper.difference(target, next->q, next->p)) <= 2 * next->step;
            const auto& point = reached ? target : *next;
            // the factors' inertia, each eighth time against the eigenvalues themselves
            const int now = steps % 8 == 0 || !point.negative ? negative(s, point) : *point.negative;
            if (steps % 8 == 0 && point.negative) CHECK(now == *point.negative);
            y += std::abs(now - before);
            before = now;
            at = *next;
        }
        INFO("seen from p = " << branch.points[k].p << " up to " << at.p << ", not to " << target.p);
        CHECK(reached);
        if (!reached) return y;
    }
    return y;
}
/// What a branch lists, against what is seen along it.
template <class S>
void compare(const S& s, const Branch<S>& branch, const ContinuationOptions& options, int points, Count& count,
             const std::string& label) {
    const double high = options.range.high;
    int listed = 0, turning = 0;
    for (const auto& event : branch.events) {
        const auto& e = event.point;
        // without an inertia: the determinant's sign at both ends of the step
        const int flips = branch.points[event.step].determinant_sign !=
                          branch.points[std::min(event.step + 1, branch.points.size() - 1)].determinant_sign;
        const int change = !S::symmetric                           ? flips
                           : e.negative_before && e.negative_after ? *e.negative_after - *e.negative_before
                                                                   : 0;
        listed += std::abs(change);
        turning += change == 0 ? e.nullity : 0;
    }
    int crossed = seen(s, branch, options, points);
    // two may be close to each other
    const auto agree = [&] { return listed == crossed || (turning > 0 && std::abs(listed - crossed) <= 2 * turning); };
    for (int finer = 8; finer <= 64 && !agree() && branch.unexplained.empty(); finer *= 8)
        crossed = seen(s, branch, options, finer * points);
    count.crossed += crossed;
    count.events += listed;
    count.unexplained += static_cast<int>(branch.unexplained.size());
    if (branch.unexplained.empty() && !agree()) {
        INFO(label << ": " << listed << " listed, " << crossed << " seen");
        CHECK(listed == crossed);
    }
    const double force = s.parameter_derivative(s.initial(), 0).cwiseAbs().maxCoeff() * high;
    for (const auto& event : branch.events) {
        INFO(label << ": " << to_string(event.point.kind) << " at " << event.point.p);
        CHECK(event.point.p >= -1e-9 * high);
        CHECK(event.point.p <= high * (1 + 1e-9));
        const double stiff = Eigen::MatrixXd(s.tangent(event.point.q, event.point.p)).cwiseAbs().maxCoeff();
        CHECK(event.point.residual < 1e-9 * std::max(force, 1e-3 * stiff * s.length()));
    }
}

/// Follows structures and compares; draw(number): a structure.
template <class S>
void follow_all(const char* kind, const auto& draw) {
    // EQUILIBRIA_STRUCTURES=300 EQUILIBRIA_POINTS=2000 for the long one
    const int structures = environment("EQUILIBRIA_STRUCTURES", 25), points = environment("EQUILIBRIA_POINTS", 200),
              first = environment("EQUILIBRIA_FIRST", 0);
    // windows of so many times the first critical load, by the stiffness without load
    const double wide = environment("EQUILIBRIA_WINDOW", 1);
    Count count;
    for (int number = first; number < first + structures; ++number) {
        const S s(draw(number), {.symmetric_images = true});
        const double high = wide * window_of(s);
        const std::string label =
            std::string(kind) + " " + std::to_string(number) + " of " + std::to_string(s.size()) + " unknowns";
        ContinuationOptions options;
        options.range = {0, high};
        options.most_steps = 150;
        options.branch.first_step = 0.01;
        options.branch.largest_step = 0.1;
        BranchStepper<S> stepper(s, options.stepping());
        const auto start = stepper.start(s.initial(), 0, 1);
        REQUIRE(start);
        const auto main = follow(stepper, *start, options);
        options.branch.parameter_weight = stepper.parameter_weight();
        compare(s, main, options, points, count, label);
        for (const auto& u : main.unexplained) UNSCOPED_INFO(label << ": " << u.reason);
        int sides = 0;
        for (const auto& event : main.events) {
            if (!is_bifurcation(event.point.kind) || sides >= 2) continue;
            const auto starts = switch_branch(stepper, event.point, main.points[event.step].tangent, 0.02);
            if (starts.empty()) continue;
            ++sides;
            const auto side = follow(stepper, starts[0], options);
            compare(s, side, options, points, count, label + ", side branch");
        }
        if (std::getenv("EQUILIBRIA_STRUCTURES"))
            std::printf("%s: high %g, %zu points, %zu events, end %s, %zu unexplained, %d side branches\n",
                        label.c_str(), high, main.points.size(), main.events.size(), to_string(main.end),
                        main.unexplained.size(), sides);
    }
    CHECK(count.events > structures);
    CHECK(count.unexplained <= structures / 20);
    if (std::getenv("EQUILIBRIA_STRUCTURES"))
        std::printf("%d %ss: %d changes listed, %d seen, %d steps unexplained\n", structures, kind, count.events,
                    count.crossed, count.unexplained);
}

}  // namespace

TEST_CASE("random structures: what is listed are the eigenvalues' changes of sign") {
    follow_all<Structure>("structure", [](int number) { return Drawer(number).draw(); });
}

TEST_CASE("random structures under follower loads: what is listed are the determinant's changes of sign") {
    follow_all<NonconservativeStructure>("follower", [](int number) { return Drawer(number).draw_with_followers(); });
}
