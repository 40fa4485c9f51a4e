#pragma once

#include <condition_variable>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "core/base/result.h"

namespace slipstick {

/// Worker threads that make the items first, first + 1, … end - 1 and hand them over in that order.
///
/// Back-pressure is one number: an item is begun only if it is less than `window` beyond the next
/// to be handed over, so at most that many are being made or waiting, however fast the workers are.
///
/// Threads: one consumer. `work` is called by several workers at once.
template <typename T>
class OrderedCrew {
 public:
  struct Options {
    int first = 0;
    int end = 0;
    int workers = 1;  ///< At least 1.
    int window = 1;   ///< At least 1.
  };
  using Work = std::function<Result<T>(int item)>;

  OrderedCrew(const Options& options, Work work)
      : options_(options), work_(std::move(work)), ticket_(options.first), due_(options.first) {
    for (int i = 0; i < options.workers; ++i) threads_.emplace_back([this] { run(); });
  }

  OrderedCrew(const OrderedCrew&) = delete;
  OrderedCrew& operator=(const OrderedCrew&) = delete;

  /// Stops: items being made are finished and dropped.
  ~OrderedCrew() {
    {
      const std::lock_guard lock(mutex_);
      stopping_ = true;
    }
    changed_.notify_all();
  }

  /// Waits for the next item. Nothing after the last one. After an error the crew makes no more.
  [[nodiscard]] Result<std::optional<T>> next() {
    std::unique_lock lock(mutex_);
    if (due_ >= options_.end) return std::optional<T>();
    changed_.wait(lock, [this] { return done_.contains(due_); });
    return hand_over();
  }

  /// Whether `next` would not wait.
  [[nodiscard]] bool ready() const {
    const std::lock_guard lock(mutex_);
    return due_ >= options_.end || done_.contains(due_);
  }

 private:
  [[nodiscard]] Result<std::optional<T>> hand_over() {
    auto node = done_.extract(due_);
    Result<T>& item = node.mapped();
    if (!item) {
      stopping_ = true;
      due_ = options_.end;
      changed_.notify_all();
      return fail(item.error());
    }
    ++due_;
    changed_.notify_all();
    return std::optional<T>(std::move(*item));
  }

  void run() {
    std::unique_lock lock(mutex_);
    while (true) {
      changed_.wait(lock, [this] {
        return stopping_ || ticket_ >= options_.end || ticket_ < due_ + options_.window;
      });
      if (stopping_ || ticket_ >= options_.end) return;
      const int item = ticket_++;
      lock.unlock();
      Result<T> result = work_(item);
      lock.lock();
      done_.emplace(item, std::move(result));
      changed_.notify_all();
    }
  }

  const Options options_;
  const Work work_;

  mutable std::mutex mutex_;  // protects what follows; never held while working
  std::condition_variable changed_;
  int ticket_;  // next to be begun
  int due_;     // next to be handed over
  bool stopping_ = false;
  std::map<int, Result<T>> done_;

  std::vector<std::jthread> threads_;  // last: joined before the rest goes
};

}  // namespace slipstick
