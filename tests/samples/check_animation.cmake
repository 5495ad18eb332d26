# cmake -D FILE=x.gltf -D BODIES=n -P check_animation.cmake: is it JSON, and do n bodies move in it?
file(READ ${FILE} text)
string(JSON channels LENGTH "${text}" animations 0 channels)
string(JSON nodes LENGTH "${text}" nodes)
math(EXPR wanted_channels "2 * ${BODIES}")
math(EXPR wanted_nodes "${BODIES} + 2")
if(NOT channels EQUAL wanted_channels OR NOT nodes EQUAL wanted_nodes)
  message(FATAL_ERROR "${FILE}: ${channels} channels and ${nodes} nodes for ${BODIES} bodies")
endif()
