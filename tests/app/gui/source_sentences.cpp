#include "source_sentences.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

namespace glisson::test {

namespace {

enum class Kind : std::uint8_t { Word, Sign, Text, Character };

struct Token {
  Kind kind;
  std::string text;
  int line;
};

bool isWordLetter(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Comments and preprocessor lines dropped, neighbouring literals joined, escapes resolved.
class Lexer {
 public:
  explicit Lexer(std::string text) : text_(std::move(text)) {}

  std::vector<Token> tokens() {
    while (at_ < text_.size()) {
      next();
    }
    return std::move(tokens_);
  }

 private:
  [[nodiscard]] bool here(std::string_view what) const { return text_.compare(at_, what.size(), what) == 0; }
  void skipTo(std::size_t end) {
    end = std::min(end, text_.size());
    line_ += static_cast<int>(
        std::count(text_.begin() + static_cast<std::ptrdiff_t>(at_), text_.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    at_ = end;
  }
  void add(Kind kind, std::string text) {
    if (kind == Kind::Text && !tokens_.empty() && tokens_.back().kind == Kind::Text) {
      tokens_.back().text += text;
    } else {
      tokens_.push_back({kind, std::move(text), line_});
    }
  }
  void next() {
    const char c = text_[at_];
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      skipTo(at_ + 1);
    } else if (here("//") || c == '#') {
      skipTo(text_.find('\n', at_));
    } else if (here("/*")) {
      skipTo(text_.find("*/", at_) + 2);
    } else if (here("R\"")) {
      const std::size_t open = text_.find('(', at_);
      const std::string close = ")" + text_.substr(at_ + 2, open - at_ - 2) + "\"";
      const std::size_t end = text_.find(close, open);
      add(Kind::Text, text_.substr(open + 1, end - open - 1));
      skipTo(end + close.size());
    } else if (c == '"' || c == '\'') {
      literal(c);
    } else if (isWordLetter(c)) {
      std::size_t end = at_;
      while (end < text_.size() && (isWordLetter(text_[end]) || (text_[end] == '\'' && isWordLetter(text_[end + 1])))) {
        ++end;
      }
      add(Kind::Word, text_.substr(at_, end - at_));
      at_ = end;
    } else {
      sign();
    }
  }
  void literal(char quote) {
    std::string value;
    std::size_t end = at_ + 1;
    for (; end < text_.size() && text_[end] != quote; ++end) {
      if (text_[end] == '\\') {
        ++end;
        value += text_[end] == 'n' || text_[end] == 't' ? ' ' : text_[end];
      } else {
        value += text_[end];
      }
    }
    add(quote == '"' ? Kind::Text : Kind::Character, value);
    at_ = end + 1;
  }
  void sign() {
    for (const std::string_view pair : {"<<", "==", "!=", "+=", "->", "::", "&&", "||", "++", "--", "<=", ">="}) {
      if (here(pair)) {
        add(Kind::Sign, std::string(pair));
        at_ += 2;
        return;
      }
    }
    add(Kind::Sign, std::string(1, text_[at_]));
    ++at_;
  }

  std::string text_;
  std::size_t at_ = 0;
  int line_ = 1;
  std::vector<Token> tokens_;
};

constexpr char kHole = '\1';

using Range = std::pair<std::size_t, std::size_t>;  // of tokens, the end excluded
using Texts = std::vector<std::string>;

class Source {
 public:
  explicit Source(std::vector<Token> tokens) : tokens_(std::move(tokens)), partner_(tokens_.size(), 0) {
    std::vector<std::size_t> open;
    for (std::size_t n = 0; n < tokens_.size(); ++n) {
      if (isOpen(n)) {
        open.push_back(n);
      } else if (isClose(n) && !open.empty()) {
        partner_[n] = open.back();
        partner_[open.back()] = n;
        open.pop_back();
      }
    }
    findConstants();
  }

  std::vector<SourceSentence> sentences() {
    std::set<Range> ranges;
    for (std::size_t n = 0; n < tokens_.size(); ++n) {
      static const std::regex kProse(R"re([A-Za-z]{2,}[,;:)"]* [("]*[A-Za-z]{2,}|^ [a-z]{2,}|[a-z]{2,} $)re");
      if (tokens_[n].kind == Kind::Text && (std::regex_search(tokens_[n].text, kProse) || isPhase(n))) {
        ranges.insert(expressionAround(n));
      }
    }
    std::map<Range, Texts> found;
    for (const Range& range : ranges) {
      found[range] = evaluate(range.first, range.second);
    }
    std::vector<SourceSentence> result;
    for (const auto& [range, texts] : found) {
      if (partsOfOthers_.contains(range)) {
        continue;
      }
      const bool appended = range.first > 0 && is(range.first - 1, "+=");
      for (const std::string& text : texts) {
        result.push_back(
            {tokens_[range.first].line, calleeOf(range.first), filled((appended ? std::string(1, kHole) : "") + text)});
      }
    }
    return result;
  }

 private:
  [[nodiscard]] bool is(std::size_t n, std::string_view text) const {
    return n < tokens_.size() && tokens_[n].text == text && (tokens_[n].kind == Kind::Sign || tokens_[n].kind == Kind::Word);
  }
  [[nodiscard]] bool isOpen(std::size_t n) const { return is(n, "(") || is(n, "[") || is(n, "{"); }
  [[nodiscard]] bool isClose(std::size_t n) const { return is(n, ")") || is(n, "]") || is(n, "}"); }
  [[nodiscard]] bool isStop(std::size_t n) const {
    return is(n, ";") || is(n, ",") || is(n, "=") || is(n, "+=") || is(n, "<<") || is(n, "return") || is(n, "throw");
  }
  [[nodiscard]] bool isPhase(std::size_t n) const {
    for (std::size_t at = n; at > 0 && !is(at, ";") && !is(at, "{"); --at) {
      if (is(at, "report") && is(n + 1, ")")) {
        return true;
      }
    }
    return false;
  }

  /// const std::string name = ...; and constexpr const char* name = ...;
  void findConstants() {
    for (std::size_t n = 3; n + 1 < tokens_.size(); ++n) {
      const bool text = is(n - 1, "string") || is(n - 1, "*");
      bool constant = false;
      for (std::size_t back = 2; back <= 4 && back < n; ++back) {
        constant = constant || is(n - back, "const");
      }
      if (is(n + 1, "=") && text && constant && tokens_[n].kind == Kind::Word) {
        std::size_t end = n + 2;
        while (end < tokens_.size() && !is(end, ";")) {
          end = isOpen(end) && partner_[end] != 0 ? partner_[end] + 1 : end + 1;
        }
        const bool words = std::any_of(
            tokens_.begin() + static_cast<std::ptrdiff_t>(n), tokens_.begin() + static_cast<std::ptrdiff_t>(end),
            [](const Token& token) { return token.kind == Kind::Text && token.text.size() > 2 && token.text.front() != '.'; });
        if (words) {
          constants_[tokens_[n].text].emplace_back(n + 2, end);
        }
      }
    }
  }

  /// From the stop or the bracket before to the one behind; out of brackets that only group, and of std::string(...).
  [[nodiscard]] Range expressionAround(std::size_t n) const {
    std::size_t begin = n;
    std::size_t end = n;
    while (true) {
      while (begin > 0 && !isStop(begin - 1) && !isOpen(begin - 1)) {
        const bool block = is(begin - 1, "}") && tokens_[partner_[begin - 1] - 1].kind != Kind::Word;
        if (block) {
          break;
        }
        begin = isClose(begin - 1) ? partner_[begin - 1] : begin - 1;
      }
      while (end < tokens_.size() && !isStop(end) && !isClose(end)) {
        end = isOpen(end) ? partner_[end] + 1 : end + 1;
      }
      if (begin < 2 || !is(begin - 1, "(") || !is(end, ")")) {
        return {begin, end};
      }
      const Token& before = tokens_[begin - 2];
      const bool grouping = before.kind == Kind::Sign ? !isClose(begin - 2) && !is(begin - 2, ">") : before.text == "return";
      if (!grouping && before.text != "string") {
        return {begin, end};
      }
      --begin;
      end = begin;
    }
  }

  /// The texts an expression can have: choices are all taken, what is not known is a hole.
  Texts evaluate(std::size_t begin, std::size_t end) {
    std::vector<std::size_t> cuts{begin};
    for (std::size_t n = begin; n < end; ++n) {
      if (isOpen(n) && partner_[n] < end) {
        n = partner_[n];
      } else if (is(n, "?")) {
        return choice(n, end);
      } else if (is(n, "+")) {
        cuts.push_back(n + 1);
      }
    }
    Texts texts{""};
    for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
      const Texts parts = operand(cuts[cut], cut + 1 < cuts.size() ? cuts[cut + 1] - 1 : end);
      Texts longer;
      for (const std::string& text : texts) {
        for (const std::string& part : parts) {
          longer.push_back(text + part);
        }
      }
      texts = std::move(longer);
    }
    return texts;
  }

  Texts choice(std::size_t question, std::size_t end) {
    int open = 0;
    for (std::size_t n = question + 1; n < end; ++n) {
      if (isOpen(n)) {
        n = partner_[n];
      } else if (is(n, "?")) {
        ++open;
      } else if (is(n, ":") && open-- == 0) {
        Texts texts = evaluate(question + 1, n);
        std::ranges::move(evaluate(n + 1, end), std::back_inserter(texts));
        return texts;
      }
    }
    return {std::string(1, kHole)};
  }

  Texts operand(std::size_t begin, std::size_t end) {
    const Token& first = tokens_[begin];
    if (end == begin + 1 && (first.kind == Kind::Text || first.kind == Kind::Character)) {
      return {first.text};
    }
    if (is(begin, "(") && partner_[begin] == end - 1) {
      return evaluate(begin + 1, end - 1);
    }
    if (is(begin, "std") && is(begin + 2, "string") && isOpen(begin + 3) && partner_[begin + 3] == end - 1) {
      return evaluate(begin + 4, end - 1);
    }
    const auto constant = end == begin + 1 ? constants_.find(first.text) : constants_.end();
    if (constant == constants_.end() || !underWay_.insert(first.text).second) {
      return {std::string(1, kHole)};
    }
    Texts texts;
    for (const Range& range : constant->second) {
      if (range.second < begin || constant->second.size() == 1) {
        partsOfOthers_.insert(range);
        std::ranges::move(evaluate(range.first, range.second), std::back_inserter(texts));
      }
    }
    underWay_.erase(first.text);
    return texts.empty() ? Texts{std::string(1, kHole)} : texts;
  }

  [[nodiscard]] std::string calleeOf(std::size_t begin) const {
    std::size_t at = begin;
    while (at > 0 && !is(at - 1, ";") && !isOpen(at - 1)) {
      at = isClose(at - 1) ? partner_[at - 1] : at - 1;
    }
    return at > 1 && !is(at - 1, ";") && tokens_[at - 2].kind == Kind::Word ? tokens_[at - 2].text : std::string();
  }

  static std::string filled(const std::string& text) {
    static const std::regex kHoles("\1+|%[1-9]");
    std::string shown = std::regex_replace(text, kHoles, "7");
    shown.erase(0, shown.find_first_not_of(' '));
    shown.erase(shown.find_last_not_of(' ') + 1);
    return shown;
  }

  std::vector<Token> tokens_;
  std::vector<std::size_t> partner_;
  std::map<std::string, std::vector<Range>> constants_;
  std::set<Range> partsOfOthers_;
  std::set<std::string> underWay_;
};

}  // namespace

std::vector<SourceSentence> sentencesOf(const std::filesystem::path& file) {
  std::ifstream in(file);
  const std::string text((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  return Source(Lexer(text).tokens()).sentences();
}

}  // namespace glisson::test
