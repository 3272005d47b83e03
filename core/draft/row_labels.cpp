#include "draft/row_labels.h"

#include <algorithm>
#include <map>
#include <utility>

namespace weftlight::draft {
namespace {

using Votes = std::map<std::pair<int, int>, int>;  // (label, group) -> threads that have both

BitMatrix stacked(const BitMatrix& a, const BitMatrix& b) {
  BitMatrix out(a.rows() + b.rows(), a.cols());
  for (int r = 0; r < a.rows(); ++r) std::ranges::copy(a.row(r), out.row(r).begin());
  for (int r = 0; r < b.rows(); ++r) std::ranges::copy(b.row(r), out.row(a.rows() + r).begin());
  return out;
}

Votes votes_of(const Labelling& l) {
  Votes votes;
  for (size_t t = 0; t < l.group.size(); ++t)
    if (l.old_label[t] >= 0 && l.group[t] >= 0) ++votes[{l.old_label[t], l.group[t]}];
  return votes;
}

int votes_for(const Votes& votes, int label, int group) {
  const auto found = votes.find({label, group});
  return found == votes.end() ? 0 : found->second;
}

// Labels that mean a group already: those that have threads of it, otherwise any.
void keep_meanings(Labelling& l, const Votes& votes, std::vector<char>& labelled) {
  for (int i = 0; i < l.labels(); ++i) {
    const int group = l.meaning[i];
    if (group < 0 || votes_for(votes, i, group) == 0) continue;
    l.owner[i] = group;
    labelled[group] = 1;
  }
  for (int i = 0; i < l.labels(); ++i) {
    const int group = l.meaning[i];
    if (l.owner[i] >= 0 || group < 0 || labelled[group]) continue;
    l.owner[i] = group;
    labelled[group] = 1;
  }
}

// Any other label follows most of its threads, if their group has no label yet.
void follow_threads(Labelling& l, const Votes& votes, std::vector<char>& labelled) {
  std::vector<int> most(l.owner.size(), 0);
  const std::vector<char> settled = labelled;
  for (const auto& [key, count] : votes) {
    const auto [label, group] = key;
    const bool means_another = l.owner[label] >= 0 && l.owner[label] == l.meaning[label];
    if (settled[group] || l.fixed[label] || means_another || count <= most[label]) continue;
    l.owner[label] = group;
    most[label] = count;
  }
  for (const int group : l.owner)
    if (group >= 0) labelled[group] = 1;
}

// An empty label, a new one, or one that no thread needs, in that order; -1: none.
int free_label(Labelling& l, int most) {
  for (int i = 0; i < l.labels(); ++i)
    if (l.owner[i] < 0 && l.empty[i] && !l.fixed[i]) return i;
  if (l.labels() < most) {
    l.owner.push_back(-1);
    l.meaning.push_back(-1);
    l.fixed.push_back(0);
    l.empty.push_back(1);
    return l.labels() - 1;
  }
  for (int i = 0; i < l.labels(); ++i)
    if (l.owner[i] < 0 && !l.fixed[i]) return i;
  return -1;
}

// Of the groups with several labels, the label with the fewest threads; -1: none.
int spare_label(const Labelling& l, const Votes& votes) {
  std::vector<int> count(l.first.size(), 0);
  for (const int group : l.owner)
    if (group >= 0) ++count[group];
  int best = -1, fewest = 0;
  for (int i = 0; i < l.labels(); ++i) {
    if (l.owner[i] < 0 || l.fixed[i] || count[l.owner[i]] < 2) continue;
    const int threads = votes_for(votes, i, l.owner[i]);
    if (best >= 0 && threads >= fewest) continue;
    best = i;
    fewest = threads;
  }
  return best;
}

void choose_label_of_groups(Labelling& l, const Votes& votes) {
  l.label_of.assign(l.first.size(), -1);
  std::vector<int> best(l.first.size(), -1);
  for (int i = 0; i < l.labels(); ++i) {
    const int group = l.owner[i];
    if (group < 0) continue;
    const int threads = votes_for(votes, i, group);
    if (threads <= best[group]) continue;
    best[group] = threads;
    l.label_of[group] = i;
  }
}

}  // namespace

int Labelling::label(int thread) const {
  const int g = group[thread], old = old_label[thread];
  if (g < 0) return -1;
  return old >= 0 && owner[old] == g ? old : label_of[g];
}

Labelling labelling_of(const BitMatrix& rows, const std::vector<int>& row_of, const std::vector<char>& takes_part,
                       const BitMatrix& meanings) {
  Labelling l;
  const std::vector<int> first = first_equal_rows(stacked(rows, meanings));
  std::vector<int> group_at(first.size(), -1);
  for (size_t t = 0; t < row_of.size(); ++t) {
    int& group = group_at[first[row_of[t]]];
    if (takes_part[t] && group < 0) {
      group = l.groups();
      l.first.push_back(static_cast<int>(t));
    }
    l.group.push_back(takes_part[t] ? group : -1);
  }
  for (int i = 0; i < meanings.rows(); ++i) l.meaning.push_back(group_at[first[rows.rows() + i]]);
  l.old_label.assign(l.group.size(), -1);
  l.fixed.assign(l.meaning.size(), 0);
  l.empty.assign(l.meaning.size(), 0);
  l.owner.assign(l.meaning.size(), -1);
  return l;
}

bool assign_labels(Labelling& l, int most) {
  const Votes votes = votes_of(l);
  std::vector<char> labelled(l.first.size(), 0);
  keep_meanings(l, votes, labelled);
  follow_threads(l, votes, labelled);
  for (int g = 0; g < l.groups(); ++g) {
    if (labelled[g]) continue;
    int label = free_label(l, most);
    if (label < 0) label = spare_label(l, votes);
    if (label < 0) return false;
    l.owner[label] = g;
  }
  choose_label_of_groups(l, votes);
  return true;
}

}  // namespace weftlight::draft
