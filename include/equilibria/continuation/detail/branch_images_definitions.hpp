/// \file
/// See continuation/branch.hpp.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>

namespace equilibria {

namespace detail {

template <class Matrix>
class CrossingFinder;

/// What is known at configurations, as it is at their images by one of problem.images.
template <class Matrix>
class ImageMap {
public:
    ImageMap(const AnyProblem<Matrix>& problem, std::size_t image) : problem_(&problem), image_(image) {}

    AnyConfiguration operator()(const AnyConfiguration& q) const { return problem_->image(q, image_); }

    /// backward: the branch goes the other way.
    BranchPoint<Erased> operator()(const BranchPoint<Erased>& at, bool backward) const {
        BranchPoint<Erased> y = at;
        y.q = (*this)(at.q);
        y.tangent = direction(at.q, at.tangent);
        if (backward) y.tangent = {-y.tangent.q, -y.tangent.p};
        y.weak_direction = vector(at.q, at.weak_direction);
        y.weak_left = vector(at.q, at.weak_left);
        y.next_directions = columns(at.q, at.next_directions);
        if (backward) y.weak_slopes = -y.weak_slopes;
        const Eigen::Index size = at.tangent.q.size();
        y.border = {place(at.q, size, at.border.row), place(at.q, size, at.border.column)};
        return y;
    }
    CriticalPoint<Erased> operator()(const CriticalPoint<Erased>& at, bool backward) const {
        CriticalPoint<Erased> y = at;
        y.q = (*this)(at.q);
        y.null_vector = vector(at.q, at.null_vector);
        y.left_null_vector = vector(at.q, at.left_null_vector);
        y.null_vectors = columns(at.q, at.null_vectors);
        y.slope = vector(at.q, at.slope);
        for (Direction& t : y.tangents) t = direction(at.q, t);
        if (backward) std::swap(y.negative_before, y.negative_after);
        return y;
    }

private:
    /// An increment of q, as one of its image: by central differences, exact to eps^(2/3).
    Eigen::VectorXd vector(const AnyConfiguration& q, const Eigen::VectorXd& v) const {
        if (v.size() == 0 || v.isZero(0)) return v;
        const double h = difference_step(problem_->weights(q, v.size()), v);
        const AnyConfiguration here = (*this)(q);
        const auto at = [&](double by) {
            return problem_->difference(here, (*this)(problem_->retract(q, Eigen::VectorXd(by * v))));
        };
        return (at(h) - at(-h)) / (2 * h);
    }
    Direction direction(const AnyConfiguration& q, const Direction& d) const { return {vector(q, d.q), d.p}; }
    Eigen::MatrixXd columns(const AnyConfiguration& q, const Eigen::MatrixXd& m) const {
        Eigen::MatrixXd y = m;
        for (Eigen::Index c = 0; c < m.cols(); ++c) y.col(c) = vector(q, m.col(c));
        return y;
    }
    /// The unknown that becomes the largest of what this one alone becomes.
    Eigen::Index place(const AnyConfiguration& q, Eigen::Index size, Eigen::Index unknown) const {
        Eigen::Index y = 0;
        vector(q, Eigen::VectorXd::Unit(size, unknown)).cwiseAbs().maxCoeff(&y);
        return y;
    }

    const AnyProblem<Matrix>* problem_;
    std::size_t image_;
};

/// Where the last step of the branch passed a bifurcation along its null vector: the number of the image that maps the
/// branch behind it onto the branch before it, if there is one.
template <class Matrix>
std::optional<std::size_t> turns_into_image(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch,
                                            const CriticalPoint<Erased>& point) {
    const AnyProblem<Matrix>& problem = stepper.problem();
    const std::vector<AnyConfiguration> images = problem.images(point.q);
    if (images.empty() || !is_bifurcation(point.kind) || point.negative_before != point.negative_after) return {};
    const BranchPoint<Erased>& last = branch.points.back();
    const std::vector<AnyConfiguration> behind = problem.images(last.q);
    BranchPoint<Erased> at = last;
    at.q = point.q;
    at.p = point.p;
    for (std::size_t k = 0; k < images.size(); ++k) {
        if (stepper.length(stepper.difference(at, images[k], point.p)) > 1e-7) continue;
        if (stepper.length(stepper.difference(last, behind[k], last.p)) < 1e-4 * last.step) continue;
        BranchPoint<Erased> image = last;
        image.q = behind[k];
        if (lies_on(stepper, branch, image)) return k;
    }
    return {};
}

/// Puts the images of all points before the last in place of the last: as they come on the way back.
template <class Matrix>
void go_back_by_image(AnyBranchStepper<Matrix>& stepper, CrossingFinder<Matrix>& crossings, Branch<Erased>& branch,
                      std::size_t image) {
    const ImageMap<Matrix> map(stepper.problem(), image);
    branch.points.pop_back();
    const std::size_t end = branch.points.size() - 1;
    const double half = stepper.length(
        stepper.difference(branch.points[end], branch.events.back().point.q, branch.events.back().point.p));
    double arc_length = branch.points[end].arc_length;
    for (std::size_t k = end + 1; k-- > 0;) {
        BranchPoint<Erased> point = map(branch.points[k], true);
        point.step = k == end ? 2 * half : branch.points[k + 1].step;
        point.turning = k == end ? 0 : branch.points[k + 1].turning;
        arc_length += point.step;
        point.arc_length = arc_length;
        branch.points.push_back(std::move(point));
    }
    // a start is often one step from the bifurcation that it left: not to land on it
    branch.points.back().proposed_step *= 1.5;
    // what was between points k and k + 1 is between their images
    const auto step_of = [&](std::size_t k) { return 2 * end - k; };
    for (std::size_t k = branch.events.size() - 1; k-- > 0;)
        branch.events.push_back({step_of(branch.events[k].step), map(branch.events[k].point, true)});
    for (std::size_t k = branch.unexplained.size(); k-- > 0;)
        branch.unexplained.push_back({step_of(branch.unexplained[k].step), branch.unexplained[k].reason});
    std::erase_if(branch.crossings, [&](const auto& crossing) { return crossing.step == end; });
    crossings.forget();
    for (std::size_t k = end; k + 1 < branch.points.size(); ++k) crossings.add(branch, k);
}

}  // namespace detail

template <class Matrix>
Branch<Erased> image_of(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch, std::size_t image,
                        const std::vector<EventFunction<Erased>>& functions) {
    const detail::ImageMap<Matrix> map(stepper.problem(), image);
    Branch<Erased> y;
    for (const auto& point : branch.points) y.points.push_back(map(point, false));
    for (const auto& [step, point] : branch.events) y.events.push_back({step, map(point, false)});
    y.unexplained = branch.unexplained;
    y.end = branch.end;
    detail::CrossingFinder<Matrix> crossings(stepper, functions);
    for (std::size_t k = 0; k + 1 < y.points.size(); ++k) crossings.add(y, k);
    return y;
}

template <class Matrix>
std::optional<Branch<Erased>> known_image(AnyBranchStepper<Matrix>& stepper, const Branch<Erased>& branch,
                                          const BranchPoint<Erased>& start,
                                          const std::vector<EventFunction<Erased>>& functions) {
    const AnyProblem<Matrix>& problem = stepper.problem();
    const std::vector<AnyConfiguration> images = problem.images(start.q);
    if (images.empty() || branch.points.size() < 3) return std::nullopt;
    const BranchPoint<Erased>& first = branch.points.front();
    const std::vector<AnyConfiguration> firsts = problem.images(first.q);
    for (std::size_t back = 0; back < firsts.size(); ++back) {
        // the image of the branch begins next to the start, and goes the same way
        const Direction apart = stepper.difference(start, firsts[back], first.p);
        if (stepper.length(apart) > 2 * branch.points[1].step) continue;
        const detail::ImageMap<Matrix> map(problem, back);
        if (!(stepper.dot(map(first, false).tangent, start.tangent) > 0.5)) continue;
        // and the start, by the image that undoes it, lies on the branch
        for (const AnyConfiguration& image : images) {
            if (stepper.length(stepper.difference(start, problem.image(image, back), start.p)) > 1e-7) continue;
            BranchPoint<Erased> at = start;
            at.q = image;
            if (stepper.length(stepper.difference(start, image, start.p)) > 1e-9 && lies_on(stepper, branch, at))
                return image_of(stepper, branch, back, functions);
        }
    }
    return std::nullopt;
}

}  // namespace equilibria
