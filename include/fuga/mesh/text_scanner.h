// SPDX-License-Identifier: LGPL-2.1-or-later
// Copyright (C) 2026 by the Fuga authors

#ifndef fuga_mesh_text_scanner_h
#define fuga_mesh_text_scanner_h

#include <cstdint>
#include <string>
#include <string_view>

namespace fuga
{
  /**
   * Scans a text in memory line by line and, within a line, token by token (separated by blanks,
   * tabs and carriage returns). Every complaint is an InputError that begins with FILE:LINE.
   * Nothing is copied; the text must outlive the scanner.
   */
  class TextScanner
  {
  public:
    TextScanner(const std::string &name, const std::string_view whole_text);

    /** Go to the next line that is not blank; return false at the end of the text. */
    bool
    next_line();

    /**
     * Go to the next line that is not blank; the end of the text is an error: @p section was not
     * finished.
     */
    void
    require_line(const std::string_view section);

    /** Return the current line without blanks at either end. */
    std::string_view
    line() const;

    unsigned int
    line_number() const;

    /** Return the next token of the current line; empty if there is none. */
    std::string_view
    token();

    /**
     * Return the next token as an integer in [@p smallest, @p largest]; @p what names it in
     * complaints.
     */
    std::int64_t
    integer(const char *what, const std::int64_t smallest, const std::int64_t largest);

    /** Return the next token as a finite number no larger than any reasonable length. */
    double
    coordinate(const char *what);

    /** Complain if the current line goes on. */
    void
    require_end_of_line(const char *what);

    /** Throw an InputError for the current line. */
    [[noreturn]] void
    fail(const std::string &message) const;

    /** Throw an InputError for an earlier line. */
    [[noreturn]] void
    fail_at(const unsigned int line_of_text, const std::string &message) const;

    /** Return a piece of the text made fit for a message: short, printable, in quotes. */
    static std::string
    quote(const std::string_view piece);

  private:
    void
    skip_blanks();

    std::string file_name;
    std::string_view text;
    const char *cursor;
    const char *line_begin;
    const char *line_end;
    unsigned int number = 0;
  };
} // namespace fuga

#endif
