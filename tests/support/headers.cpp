// Nothing: what is compiled with it is the headers that all tests read (../CMakeLists.txt).
