# include_table.cmake accepts what the table allows and says what is wrong with the rest.
cmake_minimum_required(VERSION 3.25)

set(root ${CMAKE_CURRENT_BINARY_DIR}/include_table_test)

set(table [[
| folder | holds | may include |
|---|---|---|
| `core/` | numbers | nothing |
| `model/` | models, [links](x) and; marks | core |
| `enumerate/` | the front door | core, model |
| `locus/line/` | lines | core |
| `locus/plane/` | planes | locus/line |
| `io/` | pictures | core, model, enumerate |
]])

function(check verdict header text)
    file(REMOVE_RECURSE ${root})
    file(WRITE ${root}/docs/architecture.md "${table}")
    file(WRITE ${root}/include/equilibria/version.hpp "")
    file(WRITE ${root}/include/equilibria/equilibria.hpp "#include <equilibria/io/svg.hpp>\n")
    file(WRITE ${root}/include/equilibria/core/scalar.hpp "#include <vector>\n")
    file(WRITE ${root}/include/equilibria/model/detail/angle.hpp "#include <equilibria/core/scalar.hpp>\n")
    file(WRITE ${root}/include/equilibria/enumerate/enumerate.hpp "#include <equilibria/model/model.hpp>\n")
    file(WRITE ${root}/include/equilibria/model/model.hpp "#include <equilibria/model/detail/angle.hpp>\n")
    file(WRITE ${root}/include/equilibria/locus/line/line.hpp "#include <equilibria/core/scalar.hpp>\n")
    file(WRITE ${root}/include/equilibria/io/svg.hpp "#include <equilibria/enumerate/enumerate.hpp>\n")
    file(WRITE ${root}/include/equilibria/${header} "${text}\n")
    execute_process(
        COMMAND ${CMAKE_COMMAND} -DROOT=${root} -P ${CMAKE_CURRENT_LIST_DIR}/include_table.cmake
        RESULT_VARIABLE status ERROR_VARIABLE said
    )
    string(REGEX REPLACE "[ \n]+" " " said "${said}")
    if(verdict STREQUAL "accepted")
        if(NOT status EQUAL 0)
            message(SEND_ERROR "${header} with '${text}' should be accepted, but: ${said}")
        endif()
    elseif(status EQUAL 0 OR NOT said MATCHES "${verdict}")
        message(SEND_ERROR "${header} with '${text}' should be refused with '${verdict}', but: ${said}")
    endif()
endfunction()

check(accepted model/a.hpp "#include <equilibria/model/detail/angle.hpp>")
check(accepted model/a.hpp "#include \"equilibria/core/scalar.hpp\"")
check(accepted model/a.hpp "#include <equilibria/version.hpp>")
check(accepted model/a.hpp "// #include <equilibria/enumerate/enumerate.hpp>")
check("'model' may not include 'enumerate'" model/a.hpp "#include <equilibria/enumerate/enumerate.hpp>")
check("'model' may not include 'enumerate'" model/detail/a.hpp "  #  include \"equilibria/enumerate/enumerate.hpp\"")
check("'core' may not include 'model'" core/a.hpp "#include <equilibria/model/model.hpp>")
check("'enumerate' may not include 'io'" enumerate/a.hpp "#include <equilibria/io/svg.hpp>")
check("is a detail of 'model'" enumerate/a.hpp "#include <equilibria/model/detail/angle.hpp>")
check("another header has that name" enumerate/model.hpp "")
check(accepted locus/plane/a.hpp "#include <equilibria/locus/line/line.hpp>")
check("'locus/line' may not include 'model'" locus/line/a.hpp "#include <equilibria/model/model.hpp>")
check("'locus' is not in the table" locus/a.hpp "")
check("includes the umbrella" io/a.hpp "#include <equilibria/equilibria.hpp>")
check("write the whole path" model/a.hpp "#include \"../enumerate/enumerate.hpp\"")
check("does not exist" model/a.hpp "#include <equilibria/core/none.hpp>")
check("'attic' is not in the table" attic/a.hpp "")
check("a header stands in a room" a.hpp "")
check("every file here is a header" model/a.h "")

string(REPLACE "| nothing |" "| model, io |" table "${table}")
check("lets 'core' include 'io'" model/a.hpp "")
string(REPLACE "| model, io |" "| model |" table "${table}")
check("include each other" enumerate/a.hpp "")
string(REPLACE "| model |" "| cellar |" table "${table}")
check("'cellar', which is no room" model/a.hpp "")
set(table "no table")
check("has no table of rooms" model/a.hpp "")
