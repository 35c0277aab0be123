#pragma once
#include <set>
#include <vector>

/// Numbers by which items of a list are known, whatever else of them changes: from 1, unique in the list; 0: none yet.
namespace velum::scene {

constexpr int kMostId = 1'000'000'000;

/// A number that no item has: one more than the largest.
template <class Item>
int nextId(const std::vector<Item>& items) {
  std::set<int> taken;
  for (const Item& item : items) taken.insert(item.id);
  int last = taken.empty() || *taken.rbegin() < 0 ? 0 : *taken.rbegin();
  if (last < kMostId) return last + 1;
  // Only a file can bring so large a number: take the first that is free.
  int id = 1;
  while (taken.contains(id)) ++id;
  return id;
}

/// Gives a new id to each item that has none or has the id of an item before it.
template <class Item>
void completeIds(std::vector<Item>& items) {
  std::set<int> taken;
  std::vector<Item*> nameless;
  for (Item& item : items)
    if (item.id <= 0 || !taken.insert(item.id).second) nameless.push_back(&item);
  int next = taken.empty() || *taken.rbegin() > kMostId - int(nameless.size()) ? 1 : *taken.rbegin() + 1;
  for (Item* item : nameless) {
    while (!taken.insert(next).second) ++next;
    item->id = next;
  }
}

}  // namespace velum::scene
