#include "app/window/WindowSection.h"

#include "core/Error.h"
#include "core/io/FormerKeys.h"
#include "core/io/scene/TomlFile.h"

#include <QByteArray>
#include <QStringList>
#include <QVariantList>

#include <cmath>
#include <sstream>

namespace asperity {

namespace {

constexpr const char* kSection = "window";
constexpr std::uintmax_t kMaxBytes = 1U << 22U;  // of a file that can be a session
/// TOML has no bytes: a text that begins so is them, in base 64.
const QString kBytes = QStringLiteral("base64:");
const QString kTipX = QStringLiteral("tip/x_m");
const QString kTipY = QStringLiteral("tip/y_m");

toml::array arrayOf(const QVariantList& values);

/// Puts a value into a table (with a key) or an array.
template <typename Put>
void putValue(const QVariant& value, const Put& put) {
    switch (static_cast<QMetaType::Type>(value.type())) {
    case QMetaType::Bool:
        put(value.toBool());
        break;
    case QMetaType::Int:
    case QMetaType::LongLong:
        put(static_cast<std::int64_t>(value.toLongLong()));
        break;
    case QMetaType::Double:
        put(value.toDouble());
        break;
    case QMetaType::QByteArray:
        put((kBytes + QString::fromLatin1(value.toByteArray().toBase64())).toStdString());
        break;
    case QMetaType::QVariantList:
    case QMetaType::QStringList:
        put(arrayOf(value.toList()));
        break;
    default:
        put(value.toString().toStdString());
    }
}

toml::array arrayOf(const QVariantList& values) {
    toml::array list;
    for (const QVariant& value : values) {
        putValue(value, [&list](auto&& item) { list.push_back(item); });
    }
    return list;
}

QVariant valueOf(const toml::node& node) {
    if (const auto logical = node.value_exact<bool>()) {
        return *logical;
    }
    if (const auto integer = node.value_exact<std::int64_t>()) {
        return QVariant::fromValue<qlonglong>(*integer);
    }
    if (const auto number = node.value_exact<double>()) {
        return *number;
    }
    if (const auto text = node.value_exact<std::string>()) {
        const QString whole = QString::fromStdString(*text);
        return whole.startsWith(kBytes)
                   ? QVariant(QByteArray::fromBase64(whole.mid(kBytes.size()).toLatin1()))
                   : QVariant(whole);
    }
    QVariantList list;
    if (const toml::array* const items = node.as_array()) {
        for (const toml::node& item : *items) {
            list << valueOf(item);
        }
    }
    return list;
}

}  // namespace

std::string windowSection(const QVariantMap& kept) {
    toml::table section;
    for (auto value = kept.cbegin(); value != kept.cend(); ++value) {
        putValue(value.value(), [&section, &value](auto&& put) {
            section.insert_or_assign(value.key().toStdString(), put);
        });
    }
    std::ostringstream text;
    text << '\n' << toml::table{{kSection, section}} << '\n';
    return text.str();
}

QVariantMap withCurrentNames(const QVariantMap& kept) {
    const auto current = [](const QString& name) {
        return QString::fromStdString(std::string(currentKey(name.toStdString())));
    };
    QVariantMap renamed;
    for (auto value = kept.cbegin(); value != kept.cend(); ++value) {
        const QString key = current(value.key());
        if (key == value.key() || !kept.contains(key)) {
            const bool isName = value->type() == QVariant::String;
            renamed.insert(key, isName ? current(value->toString()) : *value);
        }
    }
    return renamed;
}

QVariantMap windowSectionOf(const std::filesystem::path& file) {
    std::error_code missing;
    const std::uintmax_t size = std::filesystem::file_size(file, missing);
    if (missing || file.extension() != ".toml" || size > kMaxBytes) {
        return {};
    }
    QVariantMap kept;
    try {
        const toml::table whole = readToml(file);
        if (const toml::table* const section = whole[kSection].as_table()) {
            for (const auto& [key, node] : *section) {
                kept.insert(QString::fromStdString(std::string(key.str())), valueOf(node));
            }
        }
    } catch (const InputError&) {  // who reads the scene says what is wrong
    }
    return withCurrentNames(kept);
}

std::optional<Vector2> keptTip(const QVariantMap& kept) {
    bool hasX = false;
    bool hasY = false;
    const Vector2 position(kept.value(kTipX).toDouble(&hasX), kept.value(kTipY).toDouble(&hasY));
    return hasX && hasY && position.allFinite() ? std::optional(position) : std::nullopt;
}

void keepTip(const Vector2& position, QVariantMap& kept) {
    kept.insert(kTipX, position.x());
    kept.insert(kTipY, position.y());
}

}  // namespace asperity
