// SPDX-License-Identifier: MIT
#include <osgTreeWind/base/RowExpression.h>

#include <osgTreeWind/base/MessageText.h>
#include <osgTreeWind/base/NameMatching.h>
#include <osgTreeWind/base/Number.h>
#include <osgTreeWind/base/SqlText.h>
#include <osgTreeWind/base/Text.h>
#include <osgTreeWind/system/Program.h>

#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <new>

namespace osgTreeWind {

namespace {

constexpr int maxValueLength = 32768, maxPatternLength = 200; // bytes
constexpr int opsPerCheck = 1000, cellsPerCheck = 8, checksAfterSlow = 100;
constexpr std::int64_t nanosecondsPerCheck = 2500000, maxExtraNanoseconds = 500000000;

Diagnostic problemAt(std::size_t at, const std::string& message) {
    return {{}, 0, 0, {}, "at character " + std::to_string(at + 1) + ": " + message};
}

bool isInteger(const std::string& text) {
    const std::size_t first = text[0] == '-' ? 1 : 0;
    return text.size() > first && text.find_first_not_of("0123456789", first) == std::string::npos;
}

} // namespace

/// A statement that selects from an endless table, whose row is always the current one.
struct RowExpression::Statement {
    ~Statement() {
        sqlite3_finalize(statement);
        sqlite3_close(database);
    }

    sqlite3* database = nullptr;
    sqlite3_stmt* statement = nullptr;
    std::vector<std::size_t> columns;
    const RowCells* row = nullptr; ///< Null: all cells are empty.
    std::int64_t lastCheck = 0, extraTime = 0;
    std::int64_t allowedCpuTime = 0; ///< That a quick expression would have at this check.
    int cpuChecks = 0,
        cells = 0; ///< Checks left that read the CPU time, because its clock is slow; cells read.
};

namespace {

using Statement = RowExpression::Statement;

struct CellTable : sqlite3_vtab {
    explicit CellTable(Statement& statement) : sqlite3_vtab{}, statement(statement) {}
    Statement& statement;
};

int connectCells(sqlite3* database, void* statement, int, const char* const*, sqlite3_vtab** table, char**) {
    auto& owner = *static_cast<Statement*>(statement);
    std::string columns = "CREATE TABLE cells(none";
    for (std::size_t i = 0; i < owner.columns.size(); ++i) // NUMERIC compares '12' with 12 as numbers
        columns += ", " + sqlCell(i) + " NUMERIC, " + sqlNumber(i) + " NUMERIC";
    *table = new (std::nothrow) CellTable(owner);
    return *table ? sqlite3_declare_vtab(database, (columns + ')').c_str()) : SQLITE_NOMEM;
}
int disconnectCells(sqlite3_vtab* table) {
    delete static_cast<CellTable*>(table);
    return SQLITE_OK;
}
int openCells(sqlite3_vtab*, sqlite3_vtab_cursor** cursor) {
    *cursor = new (std::nothrow) sqlite3_vtab_cursor{};
    return *cursor ? SQLITE_OK : SQLITE_NOMEM;
}
int closeCells(sqlite3_vtab_cursor* cursor) {
    delete cursor;
    return SQLITE_OK;
}

void giveCell(const RowCells& row, std::size_t column, bool asNumber, sqlite3_context* result) {
    const std::string text = row.text(column);
    const std::optional<double> number = row.number(column);
    constexpr std::size_t exactDigits = 15;
    const bool isWhole = number && isInteger(text);
    const bool isCode = isWhole && ((text.size() > 1 && text[0] == '0') || text.size() > exactDigits);
    if (isWhole && !isCode)
        sqlite3_result_int64(result, static_cast<sqlite3_int64>(*number));
    else if (number && (asNumber || !isCode))
        sqlite3_result_double(result, *number);
    else if (!text.empty() && !asNumber)
        sqlite3_result_text64(result, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

/// Stops an expression that takes much more CPU time than its length explains.
int checkTime(void* data) {
    auto& statement = *static_cast<Statement*>(data);
    const std::int64_t now =
        std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
    const bool isSlow = now - statement.lastCheck > nanosecondsPerCheck;
    statement.lastCheck = now;
    if (statement.cpuChecks == 0 && !isSlow)
        return 0;
    const std::int64_t cpuTime = threadTime();
    // Of the clock's next step, an unknown part was spent before.
    std::int64_t& allowed = statement.allowedCpuTime;
    allowed = statement.cpuChecks > 0 ? allowed + nanosecondsPerCheck : cpuTime;
    statement.extraTime += std::max<std::int64_t>(cpuTime - allowed, 0);
    allowed = std::clamp(allowed, cpuTime, cpuTime + threadTimeStep);
    statement.cpuChecks = isSlow ? checksAfterSlow : statement.cpuChecks - 1;
    return statement.extraTime > maxExtraNanoseconds;
}

int readCell(sqlite3_vtab_cursor* cursor, sqlite3_context* result, int index) {
    Statement& statement = static_cast<CellTable*>(cursor->pVtab)->statement;
    if (!statement.row || index == 0)
        return SQLITE_OK;
    statement.cells = (statement.cells + 1) % cellsPerCheck; // the progress handler runs once a row
    if (statement.cells == 0 && checkTime(&statement))
        return SQLITE_INTERRUPT;
    try {
        const auto cell = static_cast<std::size_t>(index - 1);
        giveCell(*statement.row, statement.columns[cell / 2], cell % 2 == 1, result);
        return SQLITE_OK;
    } catch (const std::bad_alloc&) {
        return SQLITE_NOMEM;
    }
}

const sqlite3_module& cellModule() {
    static const sqlite3_module module = [] {
        sqlite3_module m{};
        m.xConnect = connectCells;
        m.xDisconnect = disconnectCells;
        m.xBestIndex = [](sqlite3_vtab*, sqlite3_index_info*) { return SQLITE_OK; };
        m.xOpen = openCells;
        m.xClose = closeCells;
        m.xFilter = [](sqlite3_vtab_cursor*, int, const char*, int, sqlite3_value**) { return SQLITE_OK; };
        m.xNext = [](sqlite3_vtab_cursor*) { return SQLITE_OK; };
        m.xEof = [](sqlite3_vtab_cursor*) { return 0; };
        m.xColumn = readCell;
        m.xRowid = [](sqlite3_vtab_cursor*, sqlite3_int64*) { return SQLITE_ERROR; };
        return m;
    }();
    return module;
}

/// Allows one SELECT from the table of cells, and harmless functions.
int authorize(void* selects, int action, const char* first, const char* second, const char*, const char*) {
    const bool isAllowed = action == SQLITE_SELECT     ? ++*static_cast<int*>(selects) == 1
                           : action == SQLITE_FUNCTION ? isSqlFunction(orEmpty(second))
                                                       : action == SQLITE_READ && orEmpty(first) == "cells";
    return isAllowed ? SQLITE_OK : SQLITE_DENY;
}

/// `min` and `max` of one value would be those of a column, which is no value of a row.
void refuseAggregate(sqlite3_context* result, int, sqlite3_value**) {
    sqlite3_result_error(result, "min() and max() need at least two values", -1);
}

/// Opens an empty database in memory that can only evaluate expressions. @return a code of SQLite.
int openDatabase(Statement& s) {
    int code = sqlite3_open_v2(":memory:", &s.database,
                               SQLITE_OPEN_READWRITE | SQLITE_OPEN_MEMORY | SQLITE_OPEN_NOMUTEX, nullptr);
    const auto attempt = [&](int next) { code = code == SQLITE_OK ? next : code; };
    if (code != SQLITE_OK)
        return code;
    attempt(sqlite3_db_config(s.database, SQLITE_DBCONFIG_DQS_DML, 0, nullptr));
    attempt(sqlite3_db_config(s.database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr));
    attempt(sqlite3_exec(s.database, "PRAGMA temp_store = MEMORY", nullptr, nullptr, nullptr)); // no files
    attempt(sqlite3_create_module(s.database, "cells", &cellModule(), &s));
    for (const char* const name : {"min", "max"})
        attempt(sqlite3_create_function(s.database, name, 1, SQLITE_UTF8, nullptr, refuseAggregate, nullptr,
                                        nullptr));
    sqlite3_stmt* connected = nullptr; // the authorizer refuses to connect the table
    attempt(sqlite3_prepare_v2(s.database, "SELECT none FROM cells", -1, &connected, nullptr));
    sqlite3_finalize(connected);
    sqlite3_limit(s.database, SQLITE_LIMIT_LIKE_PATTERN_LENGTH, maxPatternLength);
    sqlite3_limit(s.database, SQLITE_LIMIT_ATTACHED, 0);
    sqlite3_progress_handler(s.database, opsPerCheck, checkTime, &s);
    return code;
}

std::string messageOf(const Statement& statement, int code) {
    if (code == SQLITE_TOOBIG)
        return "expected texts of at most " + std::to_string(maxValueLength) + " bytes";
    if (code == SQLITE_INTERRUPT)
        return "this takes too long";
    const std::string message = sqlite3_errmsg(statement.database);
    return message == "parser stack overflow" ? "expected less nesting" : message;
}

Diagnostic syntaxProblem(const SqlText& sql, const Statement& statement, int code) {
    const int offset = sqlite3_error_offset(statement.database);
    const std::size_t at = sql.positionOf(offset < 0 ? 0 : static_cast<std::size_t>(offset));
    const std::string message = messageOf(statement, code);
    const bool isSyntax = message.find("syntax error") != std::string::npos || message == "incomplete input";
    return problemAt(at, isSyntax ? expectedFound("an expression of SQL", sql.wordAt(at)) : message);
}

} // namespace

std::string problemOfColumn(const std::string& name, const std::vector<std::string>& columns,
                            const std::string& file) {
    std::vector<std::string> numbered; // by readCsvRows()
    for (const std::string& column : columns)
        if (column.compare(0, name.size() + 2, name + " [") == 0)
            numbered.push_back(inQuotes(column));
    if (numbered.size() > 1)
        return inQuotes(name) + " in " + file + " may be " + joined(numbered);
    const std::string similar = nearestName(name, columns);
    return "no column " + inQuotes(name) + " in " + file +
           (similar.empty() ? "" : "; did you mean " + inQuotes(similar) + '?');
}

bool mayBeColumn(const std::string& text) {
    return text.find_first_of("+-*/%()'\"|<>=") == std::string::npos;
}

Result<RowExpression> RowExpression::parse(const std::string& text, const std::vector<std::string>& columns,
                                           const std::string& file, Kind kind) {
    SqlText sql(text, columns, file);
    if (kind == Kind::Value && mayBeColumn(text) && (sql.problem() || !sql.isColumn()))
        return Diagnostic{{}, 0, 0, {}, problemOfColumn(text, columns, file)};
    if (sql.problem())
        return problemAt(sql.problem()->at, sql.problem()->message);
    if (kind == Kind::Condition ? sql.isColumn() : sql.columns().empty())
        return problemAt(kind == Kind::Condition ? text.size() : 0,
                         kind == Kind::Condition ? "expected a condition such as height > 3, found a column"
                                                 : problemOfColumn(text, columns, file));
    RowExpression expression;
    expression._text = text;
    expression._statement = std::make_shared<Statement>();
    Statement& s = *expression._statement;
    s.columns = sql.columns();
    int code = openDatabase(s), selects = 0;
    if (code != SQLITE_OK)
        return problemAt(0, messageOf(s, code));
    sqlite3_set_authorizer(s.database, authorize, &selects);
    code = sqlite3_prepare_v2(s.database, sql.statement().c_str(), -1, &s.statement, nullptr);
    sqlite3_set_authorizer(s.database, nullptr, nullptr);
    if (code != SQLITE_OK)
        return syntaxProblem(sql, s, code);
    sqlite3_limit(s.database, SQLITE_LIMIT_LENGTH, maxValueLength); // it would also limit the statement
    code = sqlite3_step(s.statement);                               // with empty cells
    if (code != SQLITE_ROW)
        return problemAt(0, messageOf(s, code));
    return expression;
}

const std::vector<std::size_t>& RowExpression::columns() const {
    return _statement->columns;
}

Diagnostics RowExpression::step(const RowCells& row) const {
    _statement->row = &row;
    const int code = sqlite3_step(_statement->statement);
    if (code == SQLITE_ROW)
        return {};
    const std::string message = messageOf(*_statement, code);
    sqlite3_reset(_statement->statement);
    return {{{}, 0, 0, {}, inQuotes(_text) + ": " + message}};
}

Result<RowExpression::Value> RowExpression::evaluate(const RowCells& row) const {
    if (Diagnostics problems = step(row); !problems.empty())
        return problems;
    sqlite3_stmt* const statement = _statement->statement;
    const int type = sqlite3_column_type(statement, 0);
    if (type == SQLITE_NULL)
        return Value();
    if (type == SQLITE_INTEGER || type == SQLITE_FLOAT)
        if (const double number = sqlite3_column_double(statement, 0); std::isfinite(number))
            return Value{numberText(number), number};
    const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement, 0));
    return Value{text ? std::string(text, static_cast<std::size_t>(sqlite3_column_bytes(statement, 0)))
                      : std::string()};
}

Result<bool> RowExpression::matches(const RowCells& row) const {
    if (Diagnostics problems = step(row); !problems.empty())
        return problems;
    return sqlite3_column_double(_statement->statement, 0) != 0.0;
}

} // namespace osgTreeWind
