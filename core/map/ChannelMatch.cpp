#include "core/map/ChannelMatch.h"

#include <algorithm>
#include <set>
#include <string>

namespace asperity {

namespace {

bool isUpper(char letter) { return letter >= 'A' && letter <= 'Z'; }
bool isLower(char letter) { return letter >= 'a' && letter <= 'z'; }

/// In lower case; a capital after a small letter begins a word, too.
std::set<std::string> wordsOf(std::string_view text) {
    std::set<std::string> words;
    std::string word;
    const auto end = [&] {
        if (!word.empty()) {
            words.insert(std::move(word));
        }
        word.clear();
    };
    char before = ' ';
    for (const char letter : text) {
        const bool isLetter = isUpper(letter) || isLower(letter);
        if (!isLetter || (isUpper(letter) && isLower(before))) {
            end();
        }
        if (isLetter) {
            word += isUpper(letter) ? static_cast<char>(letter - 'A' + 'a') : letter;
        }
        before = letter;
    }
    end();
    return words;
}

std::ptrdiff_t wordsInCommon(MapQuantity quantity, const std::set<std::string>& title) {
    return std::ranges::count_if(wordsOf(keyOf(quantity)),
                                 [&](const std::string& word) { return title.contains(word); });
}

}  // namespace

bool isMeasurable(MapQuantity quantity) {
    return quantity != MapQuantity::Validity && quantity != MapQuantity::Iterations &&
           !rowOf(quantity)->onRequest;
}

std::vector<MapQuantity> quantitiesLike(const MapPlan& plan, std::string_view unit,
                                        std::string_view title) {
    const std::set<std::string> words = wordsOf(title);
    std::vector<MapQuantity> best;
    std::ptrdiff_t most = 0;
    for (const MapQuantity quantity : plan.quantities) {
        if (!isMeasurable(quantity) || rowOf(quantity)->unit != unit) {
            continue;
        }
        const std::ptrdiff_t common = wordsInCommon(quantity, words);
        if (common > most) {
            most = common;
            best.clear();
        }
        if (common == most) {
            best.push_back(quantity);
        }
    }
    return best;
}

}  // namespace asperity
