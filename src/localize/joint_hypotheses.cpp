// SPDX-FileCopyrightText: 2026 Straightedge contributors
// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "localize/match.hpp"

namespace straightedge::localize {
namespace {

constexpr std::size_t most_rivals = 32;
constexpr std::size_t most_branches = 16;  // the greatest value of the option
constexpr double left_out = 2;             // beyond the gate: a pair that fits is better than none

/// 99 % of chi-square with that many degrees of freedom (E. B. Wilson, M. M. Hilferty, 1931,
/// doi:10.1073/pnas.17.12.684).
double chi_square_quantile(double freedom) {
  const double part = 2 / (9 * freedom);
  const double root = 1 - part + 2.3263 * std::sqrt(part);
  return freedom * root * root * root;
}

/// What is left uncertain under a set of pairs: how far the pose has moved, and its covariance.
struct Node {
  Matrix<state_size, 1> moved;
  StateMatrix covariance;
};

class Tree {
 public:
  Tree(const WallMap& map, const PairList& list, const MatchOptions& options, Assignment& best,
       std::vector<Assignment>& rivals)
      : map_(map), list_(list), options_(options), best_(best), rivals_(rivals) {
    for (std::uint32_t i = 0; i + 1 < list.starts.size(); ++i) {
      if (list.starts[i] < list.starts[i + 1]) order_.push_back(i);
    }
    // The surest lines first: what they leave uncertain decides the others.
    std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return list.pairs[list.starts[a]].var_theta < list.pairs[list.starts[b]].var_theta;
    });
    current_.pair.assign(list.starts.size() - 1, no_pair);
    best_ = current_;
    best_.cost = 1e300;
    rivals_.clear();
  }

  void search(const PoseBelief& belief) {
    visit({{}, belief.covariance}, 0, 0, 0);
    std::erase_if(rivals_, [&](const Assignment& a) { return !(a.cost <= best_.cost + options_.ambiguity); });
  }

 private:
  struct Child {
    double chi_square = 0;
    std::uint32_t pair = 0;
  };

  /// What the pair would do to the node: its errors as they are left, and how much of them moves the pose.
  struct Effect {
    Matrix<2, 1> errors;
    StateWithLine with_errors;
    Matrix2 inverse;
    double chi_square = 0;
  };

  bool effect_of(const Node& node, std::uint32_t index, Effect& effect) const {
    const LinePair& pair = list_.pairs[index];
    const Wall& wall = map_.walls()[pair.wall];
    const Matrix<2, state_size> h = by_state(pair, wall);
    effect.errors = h * node.moved;
    effect.errors.v[0] += pair.angle;
    effect.errors.v[1] += pair.offset;
    effect.with_errors = node.covariance * transposed(h);
    if (!invert(h * effect.with_errors + own_covariance(pair, wall), effect.inverse)) return false;
    effect.chi_square = (transposed(effect.errors) * (effect.inverse * effect.errors)).v[0];
    return effect.chi_square <= options_.gate;
  }

  Node corrected(const Node& node, std::uint32_t index) const {
    Effect effect;
    Node next = node;
    if (!effect_of(node, index, effect)) return next;
    const StateWithLine gain = effect.with_errors * effect.inverse;
    next.moved -= gain * effect.errors;
    next.covariance -= gain * transposed(effect.with_errors);
    return next;
  }

  /// The pairs of the line that fit what is above them, the likeliest first.
  std::size_t children_of(const Node& node, std::uint32_t line, double room, Child* children) const {
    std::size_t count = 0;
    for (std::uint32_t i = list_.starts[line]; i < list_.starts[line + 1]; ++i) {
      Effect effect;
      if (effect_of(node, i, effect) && effect.chi_square <= room) children[count++] = {effect.chi_square, i};
    }
    std::sort(children, children + count, [](const Child& a, const Child& b) {
      return a.chi_square < b.chi_square || (a.chi_square == b.chi_square && a.pair < b.pair);
    });
    return count;
  }

  void keep() {
    if (current_.cost < best_.cost) {
      if (best_.cost < 1e300) rivals_.push_back(best_);
      best_ = current_;
    } else {
      rivals_.push_back(current_);
    }
    if (rivals_.size() <= most_rivals) return;
    const auto worst =
        std::max_element(rivals_.begin(), rivals_.end(),
                         [](const Assignment& a, const Assignment& b) { return a.cost < b.cost; });
    rivals_.erase(worst);
  }

  void visit(const Node& node, std::size_t depth, double chi_squares, int pairs) {
    if (current_.cost > best_.cost + options_.ambiguity) return;
    if (++nodes_ > options_.max_nodes && best_.cost < 1e300) return;
    if (depth == order_.size()) return keep();
    const std::uint32_t line = order_[depth];
    Child children[most_branches];
    const double room = chi_square_quantile(2 * (pairs + 1)) - chi_squares;
    const std::size_t count = children_of(node, line, room, children);
    const double cost = current_.cost;
    for (std::size_t i = 0; i < count; ++i) {
      current_.pair[line] = children[i].pair;
      current_.cost = cost + children[i].chi_square;
      if (current_.cost > best_.cost + options_.ambiguity) break;
      visit(corrected(node, children[i].pair), depth + 1, chi_squares + children[i].chi_square, pairs + 1);
    }
    current_.pair[line] = no_pair;
    current_.cost = cost + options_.gate + left_out;
    visit(node, depth + 1, chi_squares, pairs);
    current_.cost = cost;
  }

  const WallMap& map_;
  const PairList& list_;
  const MatchOptions& options_;
  Assignment& best_;
  std::vector<Assignment>& rivals_;
  Assignment current_;
  std::vector<std::uint32_t> order_;
  std::uint32_t nodes_ = 0;
};

}  // namespace

void joint_hypotheses(const WallMap& map, const PoseBelief& belief, const PairList& list,
                      const MatchOptions& options, Assignment& best, std::vector<Assignment>& rivals) {
  Tree(map, list, options, best, rivals).search(belief);
}

}  // namespace straightedge::localize
