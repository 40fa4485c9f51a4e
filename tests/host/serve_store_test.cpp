// What the daemon was given it keeps, across any end.
#include <catch2/catch.hpp>
#include <fstream>

#include "host/serve/store.h"
#include "tests/support/temporary_folder.h"

using namespace slipstick;
using Catch::Contains;

namespace {

// A store, and verbs for what is done with it.
struct Shelf {
  test::TemporaryFolder folder;
  std::optional<Store> store;

  Shelf() { reopen(); }
  void reopen() {
    store.reset();
    auto opened = Store::open(folder.path());
    INFO((opened ? "" : opened.error().message));
    REQUIRE(opened);
    store.emplace(std::move(*opened));
  }
  StoredFile add(const std::string& name, const std::string& bytes) {
    const auto path = store->incoming("1");
    std::ofstream(path, std::ios::binary) << bytes;
    const auto added = store->add_file(*FileName::from(name), path, 100);
    REQUIRE(added);
    return *added;
  }
  StoredJob queue(const StoredFile& file) {
    const auto job = store->add_job(file, "{}", 200);
    REQUIRE(job);
    return *job;
  }
  std::string bytes_of(const StoredFile& file) {
    std::ifstream stream(store->path_of(file.id, file.extension), std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  JobState state_of(const StoredJob& job) { return (**store->job(job.id)).state; }
};

}  // namespace

TEST_CASE("A stored file and a queued job are there after a restart") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  const auto job = shelf.queue(file);

  shelf.reopen();
  REQUIRE(shelf.store->recover(300) == 0);

  CHECK(shelf.bytes_of(file) == "solid");
  CHECK((*shelf.store->files()).size() == 1);
  CHECK((**shelf.store->file("part.stl")).size == 5);
  CHECK((**shelf.store->next_job()).id == job.id);
}

TEST_CASE("A job is claimed once, and one that was being printed is never queued again") {
  Shelf shelf;
  const auto job = shelf.queue(shelf.add("part.stl", "solid"));
  CHECK(*shelf.store->claim_job(job.id, 300) == true);
  CHECK(*shelf.store->claim_job(job.id, 300) == false);
  CHECK(*shelf.store->bed_occupied() == true);

  shelf.reopen();
  CHECK(*shelf.store->recover(400) == 1);

  CHECK(shelf.state_of(job) == JobState::kInterrupted);
  CHECK(!*shelf.store->next_job());
  CHECK(*shelf.store->bed_occupied() == true);
  CHECK(*shelf.store->claim_job(job.id, 500) == false);
}

TEST_CASE("A queued job is cancelled, one under way or over is not") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  const auto waiting = shelf.queue(file), running = shelf.queue(file);
  REQUIRE(*shelf.store->claim_job(running.id, 300));

  CHECK(*shelf.store->cancel_queued(waiting.id, 300) == true);
  CHECK(*shelf.store->cancel_queued(waiting.id, 300) == false);
  CHECK(*shelf.store->cancel_queued(running.id, 300) == false);
  REQUIRE(shelf.store->end_job(running.id, {JobState::kDone, "", "{}"}, 400));
  CHECK(shelf.state_of(running) == JobState::kDone);
  CHECK(shelf.state_of(waiting) == JobState::kCancelled);
}

TEST_CASE("Jobs are printed in the order they came, but one that is put first before all") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  const auto one = shelf.queue(file), two = shelf.queue(file), three = shelf.queue(file);
  CHECK((**shelf.store->next_job()).id == one.id);

  CHECK(*shelf.store->put_first(three.id) == true);
  CHECK(*shelf.store->put_first(99) == false);

  CHECK((**shelf.store->next_job()).id == three.id);
  REQUIRE(*shelf.store->claim_job(three.id, 300));
  CHECK(*shelf.store->put_first(three.id) == false);
  CHECK((**shelf.store->next_job()).id == one.id);
  REQUIRE(*shelf.store->put_first(two.id));
  CHECK((**shelf.store->next_job()).id == two.id);
}

TEST_CASE("A new upload of the same name leaves a queued job the file it was given") {
  Shelf shelf;
  const auto old = shelf.add("part.stl", "old");
  const auto job = shelf.queue(old);

  const auto fresh = shelf.add("part.stl", "new");
  REQUIRE(*shelf.store->remove_file("part.stl"));

  CHECK((**shelf.store->next_job()).file == old.id);
  CHECK(shelf.bytes_of(old) == "old");
  CHECK(shelf.bytes_of(fresh).empty());
  CHECK((*shelf.store->files()).empty());
  CHECK(!*shelf.store->remove_file("part.stl"));
  REQUIRE(*shelf.store->claim_job(job.id, 300));
  REQUIRE(shelf.store->end_job(job.id, {JobState::kFailed, "why", ""}, 400));
  REQUIRE(shelf.store->recover(500));
  CHECK(shelf.bytes_of(old) == "old");  // it may be taken up
  REQUIRE(shelf.store->clear_bed());
  REQUIRE(shelf.store->recover(600));
  CHECK(shelf.bytes_of(old).empty());  // nobody wants it any more
}

TEST_CASE("Only what was cut off last, and still lies on the bed, is printed again") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  const auto first = shelf.queue(file), last = shelf.queue(file), never = shelf.queue(file);
  REQUIRE(*shelf.store->claim_job(first.id, 300));
  REQUIRE(shelf.store->recover(310));
  REQUIRE(*shelf.store->claim_job(last.id, 320));
  REQUIRE(shelf.store->end_job(last.id, {JobState::kFailed, "the cable", ""}, 330));

  CHECK(*shelf.store->claim_again(first.id) == false);
  CHECK(*shelf.store->claim_again(never.id) == false);
  CHECK(*shelf.store->claim_again(last.id) == true);
  CHECK(shelf.state_of(last) == JobState::kPrinting);
  CHECK(*shelf.store->claim_again(last.id) == false);
  REQUIRE(shelf.store->end_job(last.id, {JobState::kInterrupted, "", ""}, 340));
  REQUIRE(shelf.store->clear_bed());
  CHECK(*shelf.store->claim_again(last.id) == false);
}

TEST_CASE("A journal goes when its print is done or the bed is cleared") {
  Shelf shelf;
  const auto job = shelf.queue(shelf.add("part.stl", "solid"));
  const auto journal = shelf.store->journal_of(job.id);
  const auto there = [&] { return shelf.store->can_be_taken_up(**shelf.store->job(job.id)); };
  REQUIRE(*shelf.store->claim_job(job.id, 300));
  std::ofstream(journal) << "all of it";
  CHECK_FALSE(there());
  REQUIRE(shelf.store->clear_bed());
  CHECK(std::filesystem::exists(journal));  // the print may have begun just now
  REQUIRE(shelf.store->recover(310));
  CHECK(there());

  REQUIRE(shelf.store->clear_bed());

  CHECK_FALSE(std::filesystem::exists(journal));
  const auto next = shelf.queue(shelf.add("next.stl", "solid"));
  REQUIRE(*shelf.store->claim_job(next.id, 320));
  std::ofstream(shelf.store->journal_of(next.id)) << "all of it";
  REQUIRE(shelf.store->end_job(next.id, {JobState::kDone, "", ""}, 330));
  CHECK_FALSE(std::filesystem::exists(shelf.store->journal_of(next.id)));
}

TEST_CASE("What a crash left without a row is removed at the start") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  const auto stray = shelf.store->path_of(99, ".stl"), half = shelf.store->incoming("7");
  std::ofstream(stray) << "stray";
  std::ofstream(half) << "half";
  const auto picture = shelf.store->picture_of(file.id), other = shelf.store->picture_of(99);
  std::ofstream(picture) << "PNG";
  std::ofstream(other) << "PNG";

  REQUIRE(shelf.store->recover(300));

  CHECK(!std::filesystem::exists(stray));
  CHECK(!std::filesystem::exists(half));
  CHECK(!std::filesystem::exists(other));
  CHECK(std::filesystem::exists(picture));
  CHECK(shelf.bytes_of(file) == "solid");
}

TEST_CASE("The queue is bounded") {
  Shelf shelf;
  const auto file = shelf.add("part.stl", "solid");
  {
    auto database = Database::open(shelf.folder.path() / "slipstick.db");
    REQUIRE(database);
    REQUIRE(
        database->change("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE "
                         "i < 1000) INSERT INTO jobs (file, spec, place, state, created) "
                         "SELECT 1, '{}', 1, 'queued', 0 FROM n"));
  }

  const auto refused = shelf.store->add_job(file, "{}", 300);

  REQUIRE(!refused);
  CHECK_THAT(refused.error().message, Contains("1000"));
}

TEST_CASE("A damaged database and one of a newer version are said to be") {
  const test::TemporaryFolder folder;
  REQUIRE(Store::open(folder.path()));
  const auto path = folder.path() / "slipstick.db";
  {
    auto database = Database::open(path);
    REQUIRE(database->query("PRAGMA user_version = 999"));
  }
  const auto newer = Store::open(folder.path());
  REQUIRE(!newer);
  CHECK_THAT(newer.error().message, Contains("newer"));

  std::filesystem::resize_file(path, 5000);
  const auto damaged = Store::open(folder.path());
  REQUIRE(!damaged);
  CHECK_THAT(damaged.error().message, Contains("slipstick.db"));
}

TEST_CASE("A transaction that is not committed did not happen") {
  const test::TemporaryFolder folder;
  auto database = Database::open(folder.path() / "a.db");
  REQUIRE(database->change("CREATE TABLE t (a INTEGER)"));
  {
    auto transaction = Database::Transaction::begin(*database);
    REQUIRE(transaction);
    REQUIRE(database->change("INSERT INTO t VALUES (1)"));
  }
  CHECK((*database->query("SELECT count(*) FROM t"))[0].integer(0) == 0);
}
