#include "core/tables/table_of.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/named.h"
#include "core/tables/csv_table.h"

namespace ink::core {

Way Way::to(std::ptrdiff_t offset) const {
    Way way = *this;
    way.offset_ += offset;
    return way;
}

Way Way::to(Step step, bool may_lack) const {
    Way way;
    way.may_lack_ = may_lack_ || may_lack;
    way.step_ = [whole = *this, step = std::move(step)](void* record, bool is_made) {
        void* part = whole.follow(record, is_made);
        return part == nullptr ? nullptr : step(part, is_made);
    };
    return way;
}

void* Way::find(const void* record) const {
    return follow(const_cast<void*>(record), false);
}

void* Way::make(void* record) const {
    return follow(record, true);
}

void* Way::follow(void* record, bool is_made) const {
    void* at = step_ ? step_(record, is_made) : record;
    return at == nullptr ? nullptr : static_cast<char*>(at) + offset_;
}

std::string TableColumns::Field::text_of(const void* record) const {
    const void* at = way.find(record);
    return at == nullptr ? std::string() : write(at);
}

void TableColumns::Field::read_into(const CsvField& field, void* record) const {
    if (read && (!way.may_lack() || !field.is_empty())) read(field, way.make(record));
}

TableColumns::TableColumns(std::string file, std::string doc)
    : info_{std::move(file), std::move(doc), {}} {}
TableColumns::TableColumns(const TableColumns&) = default;
TableColumns::~TableColumns() = default;

void TableColumns::add(Column column, Field field) {
    info_.columns.push_back(std::move(column));
    fields_.push_back(std::move(field));
}

void TableColumns::add_value(Column column, const Way& way, const ValueType& type) {
    column.is_text = type.is_text;
    add(std::move(column), {way, type.write, type.read});
}

void TableColumns::add_named(Column column,
                             const Way& way,
                             const CountedType& type,
                             std::vector<std::string> names) {
    column.is_text = true;
    const Write write = [=](const void* value) { return csv_field(names.at(type.load(value))); };
    const Read read = [=](const CsvField& field, void* value) {
        const auto at = std::find(names.begin(), names.end(), field.text());
        if (at == names.end()) field.refuse(fmt::format("{}", fmt::join(names, ", ")));
        type.store(value, static_cast<std::size_t>(at - names.begin()));
    };
    add(std::move(column), {way, write, read});
}

std::size_t TableColumns::find(const std::string& name) const {
    const Column* at = find_named(info_.columns, name);
    if (at == nullptr) throw Error(info_.file, "it has no column " + name, heading(info_));
    return static_cast<std::size_t>(at - info_.columns.data());
}

std::string TableColumns::line(const void* record) const {
    std::string text;
    for (const Field& field : fields_) {
        if (&field != &fields_.front()) text += ',';
        text += field.text_of(record);
    }
    return text + '\n';
}

void TableColumns::read_into(const CsvTable& table, std::size_t i, void* record) const {
    for (std::size_t column = 0; column < fields_.size(); ++column)
        fields_[column].read_into(CsvField(table, i, column), record);
}

}  // namespace ink::core
