// SPDX-License-Identifier: MIT
#include <osgTreeWind/growth/PackedForm.h>

#include <zlib.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace osgTreeWind {
namespace {

using Word = std::uint32_t;

constexpr std::size_t headerWords = 4, metamerWords = 11;
constexpr std::size_t maxPackedMetamers = 1 << 22;

template <typename T>
Word wordOf(T value) {
    static_assert(sizeof(T) == sizeof(Word));
    Word word;
    std::memcpy(&word, &value, sizeof word);
    return word;
}

template <typename T>
void set(T& value, Word word) {
    static_assert(sizeof(T) == sizeof(Word));
    std::memcpy(&value, &word, sizeof word);
}

/// The words of a metamer. Parents are stored relative to the metamer, and axes relative to the previous
/// metamer's: such small numbers compress well.
std::array<Word, metamerWords> wordsOf(const GrownMetamer& m, std::size_t index, int previousAxis) {
    return {wordOf(m.position.x),
            wordOf(m.position.y),
            wordOf(m.position.z),
            static_cast<Word>(index) - wordOf(m.parent),
            wordOf(m.axis) - wordOf(previousAxis),
            wordOf(m.order),
            wordOf(m.born),
            Word(m.dead ? 1 : 0),
            wordOf(m.radius),
            wordOf(m.light),
            wordOf(m.leafArea)};
}

GrownMetamer metamerOf(const std::array<Word, metamerWords>& words, std::size_t index, int previousAxis) {
    GrownMetamer m;
    set(m.position.x, words[0]);
    set(m.position.y, words[1]);
    set(m.position.z, words[2]);
    set(m.parent, static_cast<Word>(index) - words[3]);
    set(m.axis, words[4] + wordOf(previousAxis));
    set(m.order, words[5]);
    set(m.born, words[6]);
    m.dead = words[7] != 0;
    set(m.radius, words[8]);
    set(m.light, words[9]);
    set(m.leafArea, words[10]);
    return m;
}

bool isValid(const GrownMetamer& m, std::size_t index) {
    const bool hasParent = index == 0 ? m.parent == -1 : m.parent >= 0 && m.parent < static_cast<int>(index);
    const float sum = m.position.x + m.position.y + m.position.z + m.radius + m.light + m.leafArea;
    return hasParent && m.axis >= 0 && m.order >= 0 && m.born >= 0 && std::isfinite(sum);
}

/// The header words, then a column for each word of the metamers. A column has the lowest bytes of all
/// metamers first, then the next ones, and so on, so that similar bytes are adjacent.
class Columns {
public:
    Columns(std::string& bytes, std::size_t metamers) : _bytes(bytes), _metamers(metamers) {}
    static std::size_t sizeFor(std::size_t metamers) {
        return sizeof(Word) * (headerWords + metamerWords * metamers);
    }

    void putHeader(std::size_t i, Word word) { put(sizeof(Word) * i, 1, word); }
    Word header(std::size_t i) const { return get(sizeof(Word) * i, 1); }
    void put(std::size_t metamer, const std::array<Word, metamerWords>& words) {
        for (std::size_t i = 0; i < metamerWords; ++i)
            put(columnAt(i) + metamer, _metamers, words[i]);
    }
    std::array<Word, metamerWords> words(std::size_t metamer) const {
        std::array<Word, metamerWords> words{};
        for (std::size_t i = 0; i < metamerWords; ++i)
            words[i] = get(columnAt(i) + metamer, _metamers);
        return words;
    }

private:
    std::size_t columnAt(std::size_t i) const { return sizeof(Word) * (headerWords + i * _metamers); }
    void put(std::size_t place, std::size_t stride, Word word) {
        for (std::size_t byte = 0; byte < sizeof word; ++byte)
            _bytes[place + byte * stride] = static_cast<char>(word >> (8 * byte));
    }
    Word get(std::size_t place, std::size_t stride) const {
        Word word = 0;
        for (std::size_t byte = 0; byte < sizeof word; ++byte)
            word |= Word(static_cast<unsigned char>(_bytes[place + byte * stride])) << (8 * byte);
        return word;
    }

    std::string& _bytes;
    std::size_t _metamers;
};

} // namespace

std::string packedForm(const GrownForm& form) {
    const auto count = static_cast<Word>(form.metamers.size()); // precedes the compressed bytes
    std::string plain(Columns::sizeFor(count), '\0');
    Columns columns(plain, count);
    columns.putHeader(0, wordOf(form.years));
    columns.putHeader(1, wordOf(form.spread));
    columns.putHeader(2, wordOf(form.heightFactor));
    columns.putHeader(3, wordOf(form.widthFactor));
    int axis = 0;
    for (std::size_t i = 0; i < count; ++i) {
        columns.put(i, wordsOf(form.metamers[i], i, axis));
        axis = form.metamers[i].axis;
    }
    uLongf size = compressBound(plain.size());
    std::string packed(sizeof count + size, '\0');
    std::memcpy(packed.data(), &count, sizeof count);
    compress2(reinterpret_cast<Bytef*>(packed.data() + sizeof count), &size,
              reinterpret_cast<const Bytef*>(plain.data()), plain.size(), Z_BEST_SPEED);
    packed.resize(sizeof count + size);
    return packed;
}

std::optional<GrownForm> unpackedForm(const std::string& bytes) {
    Word count = 0;
    if (bytes.size() < sizeof count)
        return std::nullopt;
    std::memcpy(&count, bytes.data(), sizeof count);
    if (count == 0 || count > maxPackedMetamers)
        return std::nullopt;
    std::string plain(Columns::sizeFor(count), '\0');
    uLongf size = plain.size();
    if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data() + sizeof count),
                   bytes.size() - sizeof count) != Z_OK ||
        size != plain.size())
        return std::nullopt;
    const Columns columns(plain, count);
    GrownForm form;
    set(form.years, columns.header(0));
    set(form.spread, columns.header(1));
    set(form.heightFactor, columns.header(2));
    set(form.widthFactor, columns.header(3));
    form.metamers.reserve(count);
    int axis = 0;
    for (std::size_t i = 0; i < count; ++i) {
        form.metamers.push_back(metamerOf(columns.words(i), i, axis));
        axis = form.metamers.back().axis;
        if (!isValid(form.metamers.back(), i))
            return std::nullopt;
    }
    return form;
}

} // namespace osgTreeWind
