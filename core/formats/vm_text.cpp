#include "core/formats/vm_text.h"

#include <fmt/format.h>

#include <array>
#include <limits>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/base/number_text.h"
#include "core/solid/expr_model.h"

namespace slipstick {
namespace {

struct NamedOp {
  std::string_view name;
  Op op;
};

constexpr std::array<NamedOp, 30> kOps{{
    {"var-x", Op::kX},       {"var-y", Op::kY},     {"var-z", Op::kZ},
    {"abs", Op::kAbs},       {"neg", Op::kNegate},  {"sqrt", Op::kSqrt},
    {"square", Op::kSquare}, {"floor", Op::kFloor}, {"ceil", Op::kCeil},
    {"round", Op::kRound},   {"sin", Op::kSin},     {"cos", Op::kCos},
    {"tan", Op::kTan},       {"asin", Op::kAsin},   {"acos", Op::kAcos},
    {"atan", Op::kAtan},     {"ln", Op::kLn},       {"not", Op::kNot},
    {"exp", Op::kExp},       {"add", Op::kAdd},     {"sub", Op::kSubtract},
    {"mul", Op::kMultiply},  {"div", Op::kDivide},  {"min", Op::kMin},
    {"max", Op::kMax},       {"atan2", Op::kAtan2}, {"compare", Op::kCompare},
    {"mod", Op::kModulo},    {"and", Op::kAnd},     {"or", Op::kOr},
}};

const NamedOp* find_op(std::string_view name) {
  for (const NamedOp& named : kOps) {
    if (named.name == name) return &named;
  }
  return nullptr;
}

std::vector<std::string_view> words_of(std::string_view line) {
  constexpr std::string_view kBlanks = " \t\r";
  std::vector<std::string_view> words;
  while (true) {
    const std::size_t start = line.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return words;
    line.remove_prefix(start);
    const std::size_t end = std::min(line.find_first_of(kBlanks), line.size());
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

class Reader {
 public:
  // Nothing, or what is wrong with the statement.
  std::string add(const std::vector<std::string_view>& words) {
    if (words.size() < 2) return "a statement needs a name and an operation";
    if (words[1] == "const") return add_constant(words);
    const NamedOp* named = find_op(words[1]);
    if (named == nullptr) return fmt::format("operation '{}' is not supported", words[1]);
    const std::size_t operands = is_binary(named->op) ? 2 : is_unary(named->op) ? 1 : 0;
    if (words.size() < 2 + operands) {
      return fmt::format("'{}' needs {} operands", words[1], operands);
    }
    std::array<Graph::Id, 2> ids{};
    for (std::size_t i = 0; i < operands; ++i) {
      const auto at = known_.find(words[2 + i]);
      if (at == known_.end()) return fmt::format("'{}' is not defined above", words[2 + i]);
      ids[i] = at->second;
    }
    define(words[0], operands == 0   ? graph_.variable(named->op)
                     : operands == 1 ? graph_.unary(named->op, ids[0])
                                     : graph_.binary(named->op, ids[0], ids[1]));
    return {};
  }

  [[nodiscard]] std::optional<Graph::Id> root() const { return root_; }
  [[nodiscard]] Graph take_graph() { return std::move(graph_); }

 private:
  std::string add_constant(const std::vector<std::string_view>& words) {
    const auto value = words.size() > 2 ? parse_number(words[2]) : std::nullopt;
    if (!value) return "'const' needs a number";
    // The format's constants are 32-bit.
    define(words[0], graph_.constant(static_cast<double>(static_cast<float>(*value))));
    return {};
  }

  void define(std::string_view name, Graph::Id id) {
    known_.insert_or_assign(name, id);
    root_ = id;
  }

  Graph graph_;
  std::unordered_map<std::string_view, Graph::Id> known_;  // views of the text
  std::optional<Graph::Id> root_;
};

}  // namespace

Result<std::unique_ptr<Model>> load_vm_model(std::string_view text, std::string_view name,
                                             const Box3& bounds) {
  const auto refuse = [&](std::size_t line, std::string_view why) {
    return fail(ErrorCode::kInput, fmt::format("{}:{}: {}", name, line, why));
  };
  if (text.size() > kVmBytesMax) return refuse(1, "the file is larger than 64 MiB");
  Reader reader;
  std::size_t line = 0, statements = 0;
  while (!text.empty()) {
    ++line;
    const std::size_t end = std::min(text.find('\n'), text.size());
    const auto words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (words.empty() || words[0].front() == '#') continue;
    if (++statements > kVmStatementsMax) return refuse(line, "too many statements");
    if (const std::string why = reader.add(words); !why.empty()) return refuse(line, why);
  }
  if (!reader.root()) return refuse(line, "no statement, so no solid");
  const Graph::Id value = *reader.root();
  Graph graph = reader.take_graph();
  // The format's inside is f < 0, ours f <= 0: models rely on it and are 0 on whole planes. The
  // least number there is moves 0 outside and nothing else.
  const Graph::Id least = graph.constant(std::numeric_limits<double>::denorm_min());
  const Graph::Id root = graph.binary(Op::kAdd, value, least);
  return std::make_unique<ExprModel>(std::move(graph), root, bounds);
}

}  // namespace slipstick
