# Words of the window program for fish; those of velum-batch it makes itself (velum-batch completion fish).
complete -c velum -s h -l help -d 'say the options'
complete -c velum -l help-all -d 'say the options of Qt, too'
complete -c velum -s v -l version -d 'say the version'
complete -c velum -l screenshot -r -d 'save a picture of the window once it is complete, and leave'
complete -c velum -l script -r -d 'run the commands of a file, one a line'
complete -c velum -l echo -d 'with --script: say each line when it is done, with the time and the memory that is allocated'
complete -c velum -l language -r -f -a 'en de' -d 'the language of the window'
