// SPDX-License-Identifier: MIT
#include <osgTreeWind/io/HabitCatalogue.h>

#include <osgTreeWind/base/EmbeddedTexts.h>
#include <osgTreeWind/growth/GrowthFields.h>
#include <osgTreeWind/io/ForestSections.h>
#include <osgTreeWind/io/NameMatching.h>
#include <osgTreeWind/io/ReadFields.h>

namespace osgTreeWind {
namespace {

std::map<std::string, TreeHabit> readHabits() {
    std::map<std::string, TreeHabit> habits;
    const EmbeddedText* text = findEmbeddedText("osgTreeWind/growth/habits.treewind");
    ReadLog log;
    log.file = text->name;
    TableReader::readDocument(text->text, log, [&](TableReader& root) {
        readVersion(root);
        root.tables("habit", [&](TableReader& table) {
            std::string name, like;
            table.require("name", name);
            GrowthParameters growth;
            if (table.read("like", like))
                growth.habit = habits.at(foldedName(like));
            readFields(table, growth);
            habits[foldedName(name)] = growth.habit;
        });
    });
    return habits;
}

} // namespace

const std::map<std::string, TreeHabit>& builtInHabits() {
    static const std::map<std::string, TreeHabit> habits = readHabits();
    return habits;
}

} // namespace osgTreeWind
