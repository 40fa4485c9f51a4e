// docs/openapi.json describes the routes there are, all of them and no others.
#include <array>
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "host/serve/routes.h"

using namespace slipstick;
using nlohmann::json;

namespace {

std::string name_of(HttpMethod method) {
  switch (method) {
    case HttpMethod::kGet:
      return "get";
    case HttpMethod::kPost:
      return "post";
    case HttpMethod::kPut:
      return "put";
    case HttpMethod::kDelete:
      return "delete";
    case HttpMethod::kOther:
      break;
  }
  return "other";
}

json document() {
  return json::parse(std::ifstream(std::string(SLIPSTICK_SOURCE_DIR) + "/docs/openapi.json"));
}

// The names in braces.
std::set<std::string> parameters_of(const std::string& path) {
  std::set<std::string> names;
  for (std::size_t at = 0; (at = path.find('{', at)) != path.npos; ++at) {
    names.insert(path.substr(at + 1, path.find('}', at) - at - 1));
  }
  return names;
}

}  // namespace

TEST_CASE("The API's document describes every route, and no other") {
  std::set<std::string> described, there;
  const json paths = document()["paths"];
  for (const auto& [path, operations] : paths.items()) {
    for (const auto& [method, operation] : operations.items()) {
      if (method != "parameters") described.insert(method + " " + path);
    }
  }
  for (const Route& route : routes()) {
    if (route.pattern.starts_with("/api/v1/") || route.pattern == "/metrics") {
      there.insert(name_of(route.method) + " " + std::string(route.pattern));
    }
  }

  CHECK(described == there);
}

TEST_CASE("Every operation says which scope it needs, and the right one") {
  constexpr std::array<const char*, 6> kNames{"anyone",  "read",  "print",
                                              "control", "admin", "account"};
  const json paths = document()["paths"];
  for (const Route& route : routes()) {
    const std::string pattern(route.pattern);
    if (!paths.contains(pattern)) continue;
    INFO(pattern);
    CHECK(paths[pattern][name_of(route.method)].value("x-scope", "") ==
          kNames.at(static_cast<std::size_t>(route.access)));
  }
}

TEST_CASE("Every operation says what it does, what it answers, and which parameters it has") {
  const json paths = document()["paths"];
  for (const auto& [path, operations] : paths.items()) {
    std::set<std::string> named;
    for (const json& parameter : operations.value("parameters", json::array())) {
      if (parameter["in"] == "path") named.insert(parameter["name"].get<std::string>());
    }
    INFO(path);
    CHECK(named == parameters_of(path));
    for (const auto& [method, operation] : operations.items()) {
      if (method == "parameters") continue;
      INFO(method);
      CHECK(!operation.value("summary", "").empty());
      CHECK(!operation.value("responses", json::object()).empty());
    }
  }
}
