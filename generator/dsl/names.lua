-- names.lua -- which names a scene may give: they become C identifiers of the emitted code.
--
-- A scene's name is the prefix of every emitted function, a parameter's name a C variable and, in capitals, an
-- enumerator (BRICK_A).  Refused here, on the user's line: what is no identifier, keywords of C and C++, names
-- that the C standard reserves, and names that would collide with emitted ones.
-- SPDX-License-Identifier: GPL-3.0-or-later

local names = {}

local keywords = {}
for word in string.gmatch([[
  auto break case char const continue default do double else enum extern float for goto if inline int long register
  restrict return short signed sizeof static struct switch typedef union unsigned void volatile while
  alignas alignof and and_eq asm bitand bitor bool catch class compl concept const_cast constexpr decltype delete
  dynamic_cast explicit export false friend mutable namespace new noexcept not not_eq nullptr operator or or_eq
  private protected public reinterpret_cast static_assert static_cast template this thread_local throw true try
  typeid typename using virtual wchar_t xor xor_eq
  char8_t char16_t char32_t consteval constinit co_await co_return co_yield requires typeof typeof_unqual
  main NULL errno INFINITY NAN assert I complex linux unix i386 MAXFLOAT]], "%S+") do
  keywords[word] = true
end

-- Macros that a header of the standard library may put before the emitted one (C11: 5.2.4.2, 7.3 to 7.27, 7.31).
for word in string.gmatch([[BUFSIZ EOF FILENAME_MAX FOPEN_MAX L_tmpnam TMP_MAX SEEK_CUR SEEK_END SEEK_SET stdin stdout
  stderr EXIT_FAILURE EXIT_SUCCESS MB_CUR_MAX MB_LEN_MAX RAND_MAX CLOCKS_PER_SEC CHAR_BIT DECIMAL_DIG EDOM EILSEQ ERANGE
  SIZE_MAX PTRDIFF_MAX PTRDIFF_MIN WCHAR_MAX WCHAR_MIN math_errhandling MATH_ERRNO MATH_ERREXCEPT SNAN]], "%S+") do
  keywords[word] = true
end
-- Whole families of them; M_PI and its kin are of POSIX.
local families = { "^M_[%u%d]", "^FP_%u", "^HUGE", "^FLT_", "^DBL_", "^LDBL_", "^U?INT[%w_]*_M[AI][XN]$",
  "^[SU]?CHAR_M[AI][XN]$", "^U?SHRT_M[AI][XN]$", "^U?L?LONG_M[AI][XN]$", "^SIG%u", "^SIG_%u", "^FE_%u" }

local function is_macro(s)
  for _, pattern in ipairs(families) do
    if string.find(s, pattern) then return true end
  end
  return false
end

local taken = {} -- enumerators of the emitted header, without the scene's prefix
for word in string.gmatch([[PI QW QX QY QZ WX WY WZ UX UY UZ NX NU NP PLANNED_STEP PLANNED_TOLERANCE VERSION
  SCENE_HASH]], "%S+") do
  taken[word] = true
end

-- nil if `s` can be a name in C, else the rule it breaks.
function names.identifier(s)
  if type(s) ~= "string" or not string.find(s, "^%a[%w_]*$") then
    return "must be a C identifier (a letter, then letters, digits, _)"
  end
  if #s > 31 then return "must have at most 31 characters" end
  if keywords[s] or is_macro(s) then -- linux is a macro of gcc's, outside its standard modes
    return "must not be a word of C or C++"
  end
  if string.find(s, "__", 1, true) then return "must not contain __ (reserved in C++)" end
  return nil
end

-- NAME.h in a folder that a compiler searches would stand before the header of C; some names no file can have on
-- Windows.
local headers = {}
for word in string.gmatch([[
  assert complex ctype errno fenv float inttypes iso646 limits locale math setjmp signal stdalign stdarg stdatomic
  stdbool stddef stdint stdio stdlib stdnoreturn string tgmath threads time uchar wchar wctype
  aux con nul prn]], "%S+") do
  headers[word] = true
end

-- The same for a scene, which is also the name of files.
function names.scene(s)
  local rule = names.identifier(s)
  if rule then return rule end
  if headers[string.lower(s)] then return "must not be that of a header of C or of a device" end
  return nil
end

-- The same for a parameter: also against the header's own enumerators.
function names.parameter(s)
  local rule = names.identifier(s)
  if rule then return rule end
  if taken[string.upper(s)] then return "is taken by the emitted code" end
  return nil
end

return names
