-- completions.lua -- completion of the command line for bash, zsh and fish, from the program's own tables.
-- SPDX-License-Identifier: GPL-3.0-or-later
--
--     lua5.4 docs/tools/completions.lua DIRECTORY      in the project's root, after make: `make completions`
--
-- Writes DIRECTORY/polhode.bash, DIRECTORY/_polhode and DIRECTORY/polhode.fish.  Scenes are *.lua of the folder and
-- what `polhode list bodies` names.  A comma in a value begins the next word where an option takes several.

package.path = "./?.lua;" .. package.path
package.cpath = "build/lua/?.so;" .. package.cpath

local completed = require "docs.tools.completed"

local completions = {}

local head = [[
# Completion of polhode for %s.  Made by `make completions` from the program's own tables.
# SPDX-License-Identifier: GPL-3.0-or-later
]]

local function names_of(list)
  local names = {}
  for i, entry in ipairs(list) do names[i] = entry.name end
  return table.concat(names, " ")
end

local function single(text) return "'" .. string.gsub(text, "'", "'\\''") .. "'" end

-- ---- bash ----

-- What stands for a value in the case of an option.
local function bash_value(v)
  if v.words then
    return string.format("_polhode_%s %s", v.several and "several" or "words", single(table.concat(v.words, " ")))
  end
  if v.files then return "_polhode_files " .. (v.files == true and "''" or single(v.files)) end
  return v.folders and "COMPREPLY=($(compgen -d -- \"$word\"))" or ":"
end

local function bash_operand(o)
  if o == "scene" then return "_polhode_scenes" end
  if o == "file" then return "_polhode_files ''" end
  return o and "_polhode_words " .. single(table.concat(o, " ")) or ":"
end

local bash_body = [[

_polhode_words() { COMPREPLY=($(compgen -W "$1" -- "$word")); }

# the last of several words with commas between; those that stand there already are not offered again
_polhode_several() {
  local before= last=$word choice
  case $word in *,*) before=${word%,*}, last=${word##*,} ;; esac
  for choice in $(compgen -W "$1" -- "$last"); do
    case ,$before in *,"$choice",*) ;; *) COMPREPLY+=("$before$choice") ;; esac
  done
}

# files with an extension ('': any), and folders to look into
_polhode_files() {
  local file
  while IFS= read -r file; do
    if [ -d "$file" ] || [ -z "$1" ]; then COMPREPLY+=("$file"); continue; fi
    case $file in *."$1") COMPREPLY+=("$file") ;; esac
  done < <(compgen -f -- "$word")
}

_polhode_scenes() {
  _polhode_files lua
  case $word in */*) ;; *)
    COMPREPLY+=($(compgen -W "$("${COMP_WORDS[0]}" list bodies 2>/dev/null | cut -d' ' -f1)" -- "$word")) ;;
  esac
}

_polhode() {
  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]}
  COMPREPLY=()
  # bash cuts --name=value into three words
  if [ "$word" = = ]; then word=; elif [ "$before" = = ]; then before=${COMP_WORDS[COMP_CWORD-2]}; fi
  if [ "$COMP_CWORD" -eq 1 ]; then _polhode_words "$commands --help --version"; return; fi
  case "$command $before" in
]]

function completions.bash()
  local out = { string.format(head, "bash"), (string.gsub(bash_body, "%$commands",
    (string.gsub(names_of(completed.commands()), "%%", "%%%%")))) }
  local operands = {}
  for _, c in ipairs(completed.commands()) do
    for _, o in ipairs(c.options) do
      if o.value then
        out[#out + 1] = string.format("  '%s %s') %s; return ;;\n", c.name, o.name, bash_value(o.value))
      end
    end
    operands[#operands + 1] = string.format("  %s)\n    case $word in -*) _polhode_words '%s' ;; *) %s ;; esac ;;\n",
      c.name, names_of(c.options), bash_operand(c.operand))
  end
  out[#out + 1] = "  esac\n  case $command in\n" .. table.concat(operands) .. "  esac\n}\n\n"
  out[#out + 1] = "complete -o filenames -o nosort -F _polhode polhode\n"
  return table.concat(out)
end

-- ---- zsh ----

local function zsh_text(text) return (string.gsub(text, "[%[%]:\\'`$\"]", { ["["] = "(", ["]"] = ")", [":"] = " ",
  ["\\"] = "", ["'"] = "", ["`"] = "", ["$"] = "", ['"'] = "" })) end

local function zsh_value(v)
  if v.words and v.several then return ":word:_values -s , word " .. table.concat(v.words, " ") end
  if v.words then return ":word:(" .. table.concat(v.words, " ") .. ")" end
  if v.files then return ":file:_files" .. (v.files ~= true and ' -g "*.' .. v.files .. '"' or "") end
  return v.folders and ":folder:_files -/" or ":value: "
end

local function zsh_operand(o)
  if o == "scene" then return "'*:scene:_polhode_scenes'" end
  if o == "file" then return "'*:file:_files'" end
  return o and "'*:word:(" .. table.concat(o, " ") .. ")'" or ""
end

function completions.zsh()
  local out = { "#compdef polhode\n", string.format(head, "zsh"), [[

_polhode_scenes() {
  local -a installed
  installed=(${${(f)"$(_call_program scenes $words[1] list bodies 2>/dev/null)"}%% *})
  _alternative 'files:file:_files -g "*.lua"' "scenes:installed scene:($installed)"
}

_polhode() {
  local -a commands
  local line state
  commands=(
]] }
  local cases = {}
  for _, c in ipairs(completed.commands()) do
    out[#out + 1] = string.format("    '%s:%s'\n", c.name, zsh_text(c.about))
    local specs = {}
    for _, o in ipairs(c.options) do
      local equal = o.value and string.find(o.name, "^%-%-") and "=" or ""
      specs[#specs + 1] = string.format("        '*%s[%s]%s' \\\n", o.name .. equal, zsh_text(o.about),
        o.value and zsh_value(o.value) or "")
    end
    cases[#cases + 1] = string.format("    %s)\n      _arguments \\\n%s        %s ;;\n", c.name, table.concat(specs),
      zsh_operand(c.operand))
  end
  out[#out + 1] = [[
  )
  _arguments -C '1:command:->command' '*::argument:->argument'
  case $state in
  command) _describe -t commands command commands ;;
  argument)
    case $line[1] in
]] .. table.concat(cases) .. "    esac ;;\n  esac\n}\n\n_polhode \"$@\"\n"
  return table.concat(out)
end

-- ---- fish ----

local function fish_value(v)
  if v.words and v.several then
    return "-x -a " .. single("(__polhode_several " .. table.concat(v.words, " ") .. ")")
  end
  if v.words then return "-x -a " .. single(table.concat(v.words, " ")) end
  if v.files then return "-r -F" end
  return v.folders and "-x -a '(__fish_complete_directories)'" or "-x"
end

function completions.fish()
  local out = { string.format(head, "fish"), [[

# the last of several words with commas between
function __polhode_several
    set -l word (commandline -ct | string replace -r '^--[a-z-]*=' '')
    set -l before (string match -r '^.*,' -- $word)
    for choice in $argv
        string match -q -- "*,$choice,*" ",$before"; or echo $before$choice
    end
end

function __polhode_scenes
    __fish_complete_suffix .lua
    polhode list bodies 2>/dev/null | string replace -r '^(\S+)\s+' '$1\t'
end

complete -c polhode -f
]] }
  local commands = completed.commands()
  for _, c in ipairs(commands) do
    out[#out + 1] = string.format("complete -c polhode -n __fish_use_subcommand -a %s -d %s\n", c.name, single(c.about))
  end
  for _, c in ipairs(commands) do
    local when = "complete -c polhode -n '__fish_seen_subcommand_from " .. c.name .. "' "
    for _, o in ipairs(c.options) do
      local long = string.match(o.name, "^%-%-(.*)")
      out[#out + 1] = when .. (long and "-l " .. long or "-s " .. string.sub(o.name, 2)) .. " " ..
        (o.value and fish_value(o.value) .. " " or "") .. "-d " .. single(o.about) .. "\n"
    end
    if c.operand == "scene" then
      out[#out + 1] = when .. "-a '(__polhode_scenes)'\n"
    elseif c.operand == "file" then
      out[#out + 1] = when .. "-F\n"
    elseif c.operand then
      out[#out + 1] = when .. "-a " .. single(table.concat(c.operand, " ")) .. "\n"
    end
  end
  return table.concat(out)
end

-- ---- files ----

local files = { { "polhode.bash", "bash" }, { "_polhode", "zsh" }, { "polhode.fish", "fish" } }

if arg and arg[0] and string.find(arg[0], "completions.lua", 1, true) then
  for _, f in ipairs(files) do
    local file = assert(io.open(assert(arg[1], "usage: completions.lua DIRECTORY") .. "/" .. f[1], "wb"))
    assert(file:write(completions[f[2]]()))
    assert(file:close())
  end
end

return completions
